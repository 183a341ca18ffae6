#include "tools/study/same_laws.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace specula {

namespace {

constexpr std::string_view nuisance[] = {"height_m",   "sample_tilt_x_rad", "sample_tilt_y_rad",
                                         "offset_x_m", "offset_y_m",        "yaw_rad",
                                         "gain_db",    "displacement_m"};

/// Largest distance between the two distribution functions.
double distance(std::vector<double> a, std::vector<double> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double largest = 0.0;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        const double value = std::min(a[i], b[j]);
        while (i < a.size() && a[i] <= value) ++i;
        while (j < b.size() && b[j] <= value) ++j;
        largest =
            std::max(largest, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                       static_cast<double>(j) / static_cast<double>(b.size())));
    }
    return largest;
}

/// Of so large a distance, or a larger one, if both follow one law.
double probability_of(double distance, std::size_t n_a, std::size_t n_b) {
    const double n =
        static_cast<double>(n_a) * static_cast<double>(n_b) / static_cast<double>(n_a + n_b);
    const double x = distance * std::sqrt(n);
    if (x < 0.2) return 1.0;  // the sum converges slowly there; it is 1 to 12 digits
    double p = 0.0;
    for (int j = 1; j <= 100; ++j) p += (j % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * j * j * x * x);
    return std::clamp(p, 0.0, 1.0);
}

}  // namespace

double SameLaws::corrected_p() const {
    return std::min(1.0, smallest_p * static_cast<double>(std::max<std::size_t>(1, n_tests)));
}

SameLaws compare_nuisance(const std::vector<Truth>& truth, std::size_t n_classes) {
    SameLaws result;
    for (const TruthColumn& column : truth_columns) {
        if (std::find(std::begin(nuisance), std::end(nuisance), column.name) == std::end(nuisance))
            continue;
        for (std::size_t label = 0; label < n_classes; ++label) {
            std::vector<double> own, others;
            for (const Truth& frame : truth)
                if (frame.frame == 0)
                    (frame.label == label ? own : others).push_back(frame.*column.member);
            if (own.empty() || others.empty()) continue;
            ++result.n_tests;
            const double p = probability_of(distance(own, others), own.size(), others.size());
            if (p >= result.smallest_p) continue;
            result.smallest_p = p;
            result.column = column.name;
            result.label = label;
        }
    }
    return result;
}

}  // namespace specula
