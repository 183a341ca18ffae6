#include "sim/adc/start_up.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

std::vector<double> start_up_ringing(const DecimationFilter& filter) {
    const auto response = [&](int sample) {
        const double t = sample + filter.fraction;
        const double reach = filter.latency_samples + 1.0;
        const double pulse = t == 0.0 ? 1.0 : std::sin(pi * t) / (pi * t);
        return pulse * std::max(0.0, std::cos(0.5 * pi * t / reach));
    };
    std::vector<double> ringing;
    for (int k = -filter.latency_samples; k <= filter.latency_samples; ++k)
        ringing.push_back(response(k) / response(0));
    return ringing;
}

}  // namespace specula
