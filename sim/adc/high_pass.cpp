#include "sim/adc/high_pass.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

HighPass::HighPass(double corner_hz, double sample_rate_hz) {
    if (corner_hz <= 0.0) return;
    SPECULA_EXPECT(corner_hz < 0.5 * sample_rate_hz);
    const double warped = std::tan(pi * corner_hz / sample_rate_hz);
    first_ = {.gain = 1.0 / (1.0 + warped),
              .feedback = (1.0 - warped) / (1.0 + warped),
              .open = false};
    second_ = first_;
}

double HighPass::Pole::step(double input) {
    if (open) return input;
    last_output = feedback * last_output + gain * (input - last_input);
    last_input = input;
    return last_output;
}

}  // namespace specula
