#include "sim/channel/layer_path.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double frequency_hz = 60e9;
const Layer gap{.medium = {}, .thickness_m = 0.3};

TEST_CASE("waves turn between a window and the metal beneath", "[channel]") {
    const Layer window{.medium = {{4.0, 0.0}}, .thickness_m = 1e-3};
    const double path_m = layer_path_m({{window, gap}, PerfectConductor{}, frequency_hz});
    // Window and air return a third of the field each: log(1e-4) / log(1/3) turns, 9.
    CHECK(path_m == Approx(9 * (0.6 + 2e-3 / 2.0)).epsilon(0.01));
}

TEST_CASE("what lies beneath metal turns no wave", "[channel]") {
    const Layer metal{.medium = {{1.0, -1e7}}, .thickness_m = 1e-3};
    CHECK(layer_path_m({{metal, gap}, PerfectConductor{}, frequency_hz}) == 0.0);
}

}  // namespace
}  // namespace specula
