#include "tools/report/paired_difference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"

namespace specula {

PairedDifference paired_difference(const std::vector<double>& a, const std::vector<double>& b,
                                   std::uint64_t seed) {
    SPECULA_EXPECT(a.size() == b.size());
    if (a.empty()) return {};
    std::vector<double> differences(a.size());
    std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<>());
    const auto n_below = std::count_if(differences.begin(), differences.end(),
                                       [](double difference) { return difference < 0.0; });
    return {.value = bootstrap_mean(differences, {.seed = seed, .purpose = "bootstrap"}),
            .n_worlds = a.size(),
            .n_below = static_cast<std::size_t>(n_below)};
}

std::string difference_text(const PairedDifference& difference) {
    const Interval& value = difference.value;
    const double sign = value.mean < 0.0 ? -1.0 : 1.0;
    const std::string direction = value.mean < 0.0 ? "lower by " : "higher by ";
    if (difference.n_worlds < 2)
        return direction + points_text(std::abs(value.mean)) + " (one world: no interval)";
    if (!difference.is_clear())
        return format("not clearly different ({}, 95\u00a0% interval {})", points_text(value.mean),
                      range_number(value));
    const Interval size{.mean = sign * value.mean,
                        .low = sign > 0.0 ? value.low : -value.high,
                        .high = sign > 0.0 ? value.high : -value.low};
    return format("{}{} (95\u00a0% interval {})", direction, points_text(size.mean),
                  range_number(size));
}

}  // namespace specula
