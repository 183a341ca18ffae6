#include "classifier/standardiser.hpp"

#include <cmath>

#include "sim/core/expect.hpp"

namespace specula {

Standardiser fit_standardiser(const FeatureTable& rows) {
    SPECULA_EXPECT(rows.size() > 0);
    constexpr double constant_below = 1e-6;
    const auto n = static_cast<double>(rows.size());
    Standardiser result;
    for (std::size_t f = 0; f < rows.n_features; ++f) {
        double sum = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) sum += static_cast<double>(rows.row(i)[f]);
        const double mean = sum / n;
        double squares = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double deviation = static_cast<double>(rows.row(i)[f]) - mean;
            squares += deviation * deviation;
        }
        const double sd = std::sqrt(squares / n);
        SPECULA_EXPECT(std::isfinite(sd));
        const bool constant = sd <= constant_below * std::abs(mean);
        result.mean.push_back(static_cast<float>(mean));
        result.scale.push_back(constant ? 0.0f : static_cast<float>(1.0 / sd));
    }
    return result;
}

}  // namespace specula
