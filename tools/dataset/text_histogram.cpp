#include "tools/dataset/text_histogram.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t intervals = 12;
constexpr double longest_bar = 40.0;

/// The least of 1, 2, 5 times a power of ten that is not below `width`.
double round_up(double width) {
    const double decade = std::pow(10.0, std::floor(std::log10(width)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= width * (1.0 - 1e-9)) return step * decade;
    return 10.0 * decade;
}

}  // namespace

Histogram histogram_of(const std::vector<float>& values, std::size_t most) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double least = *low, span = static_cast<double>(*high) - least;
    // Below a float's resolution all values are one.
    if (!(span > 1e-6 * std::max(std::abs(least), std::abs(static_cast<double>(*high)))))
        return {.first = least, .width = 0.0, .counts = {values.size()}};
    Histogram histogram;
    histogram.width = round_up(span / static_cast<double>(most - 1));
    histogram.first = histogram.width * std::floor(least / histogram.width);
    for (const float value : values) {
        const auto at = static_cast<std::size_t>((value - histogram.first) / histogram.width);
        if (at >= histogram.counts.size()) histogram.counts.resize(at + 1);
        ++histogram.counts[at];
    }
    return histogram;
}

std::string text_histogram(const std::string& name, const std::string& unit,
                           const std::vector<float>& values) {
    const Histogram histogram = histogram_of(values, intervals);
    if (histogram.width == 0.0)
        return format("{}: {:.5g} {} in all {} frames\n", name, histogram.first, unit,
                      values.size());
    const double most =
        static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
    std::string text = format("{} ({})\n", name, unit);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const double begin = histogram.first + static_cast<double>(i) * histogram.width;
        const auto bar = static_cast<std::size_t>(
            std::ceil(longest_bar * static_cast<double>(histogram.counts[i]) / most));
        text += format("{:9.5g} to {:9.5g} {:8} |{}\n", begin, begin + histogram.width,
                       histogram.counts[i], std::string(bar, '#'));
    }
    return text;
}

}  // namespace specula
