#include "tools/specula/bar_chart.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

std::string bar_chart(const std::vector<std::string>& labels, const std::vector<float>& values,
                      double floor) {
    constexpr double width = 50.0;
    const double largest = std::max<double>(
        2.0 * floor, values.empty() ? 0.0 : *std::max_element(values.begin(), values.end()));
    std::string chart;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = std::log(std::max<double>(values[i], floor) / floor) /
                             std::log(largest / floor);
        chart += format("{} {:9.2f} |{}\n", labels[i], values[i],
                        std::string(static_cast<std::size_t>(std::lround(width * share)), '#'));
    }
    return chart;
}

}  // namespace specula
