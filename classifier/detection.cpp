#include "classifier/detection.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr double passing_share = 0.95;

std::vector<double> sorted(std::span<const double> scores) {
    std::vector<double> values(scores.begin(), scores.end());
    SPECULA_EXPECT(!values.empty());
    SPECULA_EXPECT(std::ranges::none_of(values, [](double v) { return std::isnan(v); }));
    std::ranges::sort(values);
    return values;
}

}  // namespace

Detection detection_of(const ScorePair& scores) {
    const std::vector<double> familiar = sorted(scores.familiar);
    double wins = 0.0;
    for (const double score : scores.unfamiliar) {
        const auto [low, high] = std::equal_range(familiar.begin(), familiar.end(), score);
        wins += static_cast<double>(low - familiar.begin());
        wins += 0.5 * static_cast<double>(high - low);
    }
    const auto n_familiar = static_cast<double>(familiar.size());
    const auto n_unfamiliar = static_cast<double>(scores.unfamiliar.size());
    SPECULA_EXPECT(n_unfamiliar > 0.0);
    const auto rank = static_cast<std::size_t>(std::ceil(passing_share * n_familiar - 1e-9));
    const double limit = familiar[std::clamp<std::size_t>(rank, 1, familiar.size()) - 1];
    const auto passes = [limit](double score) { return score <= limit; };
    return {.auroc = wins / (n_familiar * n_unfamiliar),
            .fpr95 = static_cast<double>(std::ranges::count_if(scores.unfamiliar, passes)) /
                     n_unfamiliar};
}

}  // namespace specula
