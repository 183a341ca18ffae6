#include "sim/recording/order_check.hpp"

#include <cmath>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

/// Three receivers of different offset and phase, a slow beat and a little noise: (rx, sample).
std::vector<std::int16_t> chirp_with(double cycles) {
    Stream stream({.seed = 2, .purpose = "chirp"});
    std::vector<std::int16_t> codes;
    for (int rx = 0; rx < 3; ++rx)
        for (int n = 0; n < 128; ++n)
            codes.push_back(static_cast<std::int16_t>(
                40 * rx - 40 + 100 * std::sin(cycles * 6.2832 * n / 128 + 2 * rx) +
                stream.normal()));
    return codes;
}

double suspicion(const std::vector<std::int16_t>& codes, const AxisOrder& order) {
    return interleaving_suspicion(arrange(codes, order));
}

TEST_CASE("codes read in the wrong one of two orders jump", "[recording]") {
    const AxisOrder by_rx{{"rx", "sample"}, {3, 128}}, interleaved{{"sample", "rx"}, {128, 3}};
    for (const double cycles : {1.0, 5.0, 11.5}) {
        const auto codes = chirp_with(cycles);
        const auto mixed = rearrange(arrange(codes, by_rx), interleaved);
        CHECK(suspicion(codes, by_rx) < 1.0);
        CHECK(suspicion(mixed, interleaved) < 1.0);
        CHECK(suspicion(mixed, by_rx) > 4.0);
        CHECK(suspicion(codes, interleaved) > 4.0);
    }
}

TEST_CASE("noise gives no order away, and one receiver has one order", "[recording]") {
    Stream stream({.seed = 3, .purpose = "noise"});
    std::vector<std::int16_t> codes;
    for (int i = 0; i < 3 * 128; ++i)
        codes.push_back(static_cast<std::int16_t>(100 * stream.normal()));
    CHECK(suspicion(codes, {{"rx", "sample"}, {3, 128}}) == Approx(1.0).margin(0.3));  // 384 draws
    CHECK(suspicion(codes, {{"sample"}, {384}}) == 0.0);
}

}  // namespace
}  // namespace specula
