#include "sim/parallel.hpp"

#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("every index is worked on once, by any number of threads", "[sim]") {
    for (const int threads : {1, 2, 3, 16}) {
        std::vector<int> worked(1000, 0);
        std::atomic<std::size_t> done{0};
        for_each_index(worked.size(), threads, [&](std::size_t i) { ++worked[i]; }, &done);
        CHECK(worked == std::vector<int>(1000, 1));
        CHECK(done == 1000);
    }
}

TEST_CASE("no indices, no work", "[sim]") {
    bool called = false;
    for_each_index(0, 2, [&](std::size_t) { called = true; });
    CHECK_FALSE(called);
}

TEST_CASE("an error in one index comes out and stops the rest", "[sim]") {
    for (const int threads : {1, 2}) {
        std::atomic<std::size_t> done{0};
        const auto work = [](std::size_t i) {
            if (i == 10) throw std::runtime_error("ten");
        };
        CHECK_THROWS_WITH(for_each_index(100000, threads, work, &done), "ten");
        CHECK(done < 100000);
    }
}

TEST_CASE("the machine offers a thread at least", "[sim]") {
    CHECK(available_threads() >= 1);
}

}  // namespace
}  // namespace specula
