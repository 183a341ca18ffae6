#include "tools/serve/work_queue.hpp"

#include <atomic>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a full line takes no more work, and what was taken is done before the end", "[serve]") {
    std::atomic<int> done{0};
    std::mutex gate;
    gate.lock();
    int taken = 0;
    {
        WorkQueue queue({.threads = 1, .most_waiting = 3});
        const auto work = [&] {
            const std::lock_guard<std::mutex> hold(gate);
            ++done;
        };
        for (int i = 0; i < 20; ++i) taken += queue.take(work);
        CHECK(taken >= 3);  // the thread may have fetched the first one already
        CHECK(taken <= 4);
        CHECK_FALSE(queue.take(work));
        gate.unlock();
        queue.finish();
        CHECK(done == taken);
        CHECK_FALSE(queue.take(work));
    }
    CHECK(done == taken);
}

}  // namespace
}  // namespace specula
