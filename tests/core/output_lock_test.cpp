#include "sim/core/output_lock.hpp"

#include <chrono>
#include <future>
#include <memory>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"

namespace specula {
namespace {

using Kind = OutputLock::Kind;

TEST_CASE("who wants to be alone is refused beside anyone", "[output_lock]") {
    const TemporaryFolder folder;
    const OutputLock held(folder / "lock", Kind::beside_others);
    CHECK_NOTHROW(OutputLock(folder / "lock", Kind::beside_others));
    CHECK_THROWS_AS(OutputLock(folder / "lock", Kind::alone), InputError);
}

TEST_CASE("who takes turns waits until the other is done", "[output_lock]") {
    const TemporaryFolder folder;
    auto held = std::make_unique<OutputLock>(folder / "lock", Kind::alone);
    std::future<void> turn = std::async(
        std::launch::async, [&] { const OutputLock mine(folder / "lock", Kind::in_turn); });
    CHECK(turn.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout);
    held.reset();
    CHECK_NOTHROW(turn.get());
}

}  // namespace
}  // namespace specula
