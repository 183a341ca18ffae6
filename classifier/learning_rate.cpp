#include "classifier/learning_rate.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr double rising_share = 0.3;
constexpr double peak_over_start = 25.0;
constexpr double start_over_end = 1e4;

struct HalfCosine {
    double from, to;
    double at(double share) const { return to + 0.5 * (from - to) * (1.0 + std::cos(pi * share)); }
};

double one_cycle(const ScheduledStep& place) {
    const double start = place.peak / peak_over_start;
    const auto n = static_cast<double>(place.n_steps);
    const auto step = static_cast<double>(place.step);
    const double top = rising_share * n - 1.0;  // the step of the peak, counted from 0
    if (step <= top) return HalfCosine{start, place.peak}.at(step / top);
    // A training of three steps or fewer has no rise, and the first of them is at the peak.
    const double begin = top > 0.0 ? top : 0.0;
    const double falling = n - 1.0 - begin;
    const double share = falling > 0.0 ? (step - begin) / falling : 0.0;
    return HalfCosine{place.peak, start / start_over_end}.at(share);
}

}  // namespace

const std::vector<std::string>& schedule_names() {
    static const std::vector<std::string> names{"constant", "cosine", "one-cycle"};
    return names;
}

double learning_rate_at(const ScheduledStep& place) {
    SPECULA_EXPECT(place.step >= 0 && place.step < place.n_steps && place.peak > 0.0);
    if (place.schedule == Schedule::one_cycle) return one_cycle(place);
    if (place.schedule == Schedule::constant) return place.peak;
    const double share = static_cast<double>(place.step) / static_cast<double>(place.n_steps);
    return HalfCosine{place.peak, 0.0}.at(share);
}

}  // namespace specula
