#include "sim/trace/scatter.hpp"

#include <algorithm>

namespace specula {

namespace {

Scatter::Extent extent_of(const std::vector<PairScatter>& pairs,
                          std::vector<double> PairScatter::*values, double when_empty) {
    bool found = false;
    Scatter::Extent extent{when_empty, when_empty};
    for (const PairScatter& pair : pairs) {
        if ((pair.*values).empty()) continue;
        const auto [low, high] = std::minmax_element((pair.*values).begin(), (pair.*values).end());
        extent.low = found ? std::min(extent.low, *low) : *low;
        extent.high = found ? std::max(extent.high, *high) : *high;
        found = true;
    }
    return extent;
}

}  // namespace

Scatter::Extent Scatter::path_m() const {
    return extent_of(rx, &PairScatter::path_m, 0.0);
}

Scatter::Extent Scatter::cos_incidence() const {
    return extent_of(rx, &PairScatter::cos_incidence, 1.0);
}

}  // namespace specula
