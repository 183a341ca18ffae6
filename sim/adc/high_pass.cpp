#include "sim/adc/high_pass.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

HighPass::Pole::Pole(double share) {
    if (share <= 0.0) return;
    SPECULA_EXPECT(share < 0.5);
    feedback = std::exp(-two_pi * share);
    // |numerator|^2 / |1 - 1/z|^2 as P + Q sin^2(pi f / rate): P from zero frequency, Q from a
    // quarter of the rate, where |1 - 1/z|^2 = 2 and |1 - feedback/z|^2 = 1 + feedback^2.
    const double at_zero = std::pow((1.0 - feedback) / (two_pi * share), 2);
    const double ratio = 0.25 / share;
    const double wanted = ratio * ratio / (1.0 + ratio * ratio);
    const double at_quarter = 0.5 * wanted * (1.0 + feedback * feedback);
    const double at_half = at_zero + 2.0 * (at_quarter - at_zero);
    SPECULA_EXPECT(at_half >= 0.0);
    now = 0.5 * (std::sqrt(at_zero) + std::sqrt(at_half));
    before = 0.5 * (std::sqrt(at_zero) - std::sqrt(at_half));
    open = false;
}

HighPass::HighPass(const Corners& corners, double sample_rate_hz)
    : first_(corners.first_hz / sample_rate_hz), second_(corners.second_hz / sample_rate_hz) {}

}  // namespace specula
