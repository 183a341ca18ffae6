#include "sim/adc/start_up.hpp"

#include <cmath>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a pulse on an output sample leaves the others alone", "[adc]") {
    const auto ringing = start_up_ringing({.latency_samples = 11, .fraction = 0.0});
    REQUIRE(ringing.size() == 23);
    for (std::size_t i = 0; i < ringing.size(); ++i)
        CHECK(ringing[i] == Approx(i == 11 ? 1.0 : 0.0).margin(1e-15));
}

TEST_CASE("between samples a pulse rings with changing sign, and dies away to either side",
          "[adc]") {
    const auto ringing = start_up_ringing({.latency_samples = 11, .fraction = 0.1});
    for (std::size_t i = 1; i + 1 < ringing.size(); ++i) {
        if (i == 10 || i == 11) continue;  // beside the pulse itself
        CHECK(ringing[i] * ringing[i - 1] < 0.0);
        const double growth = std::abs(ringing[i]) - std::abs(ringing[i - 1]);
        CHECK((i < 11 ? growth : -growth) > 0.0);
    }
}

TEST_CASE("a pulse half-way between samples comes out of both alike", "[adc]") {
    const auto ringing = start_up_ringing({.latency_samples = 11, .fraction = 0.5});
    CHECK(ringing[10] == Approx(ringing[11]));
}

}  // namespace
}  // namespace specula
