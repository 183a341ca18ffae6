#include "sim/trace/scatter.hpp"

#include <algorithm>

namespace specula {

namespace {

template <typename ValuesOf>
Scatter::Extent extent_over(const RouteScatter& scatter, ValuesOf values_of) {
    bool found = false;
    Scatter::Extent extent;
    for (const PairScatter& pair : scatter.rx) {
        const std::vector<double>& values = values_of(pair);
        if (values.empty()) continue;
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        extent.low = found ? std::min(extent.low, *low) : *low;
        extent.high = found ? std::max(extent.high, *high) : *high;
        found = true;
    }
    return extent;
}

}  // namespace

std::size_t Scatter::n_points() const {
    std::size_t n = 0;
    for (const RouteScatter& route : routes)
        for (const PairScatter& pair : route.rx) n += pair.path_m.size();
    return n;
}

Scatter::Extent path_extent_m(const RouteScatter& scatter) {
    return extent_over(
        scatter, [](const PairScatter& p) -> auto& { return p.path_m; });
}

Scatter::Extent cosine_extent(const RouteScatter& scatter) {
    return extent_over(
        scatter, [](const PairScatter& p) -> auto& { return p.cos_incidence; });
}

Scatter::Extent event_cosine_extent(const RouteScatter& scatter, std::size_t event) {
    return extent_over(
        scatter, [event](const PairScatter& p) -> auto& { return p.event_cosine[event]; });
}

}  // namespace specula
