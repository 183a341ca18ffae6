#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace specula {

/// What a classifier gets wrong if it answers for its surest examples alone.
struct RiskCoverage {
    /// (answered examples - 1): the share of wrong answers among the k surest. Equally sure ones
    /// count as if their order were drawn by chance: their mean over all orders.
    std::vector<double> risk;

    double coverage(std::size_t k) const {
        return static_cast<double>(k + 1) / static_cast<double>(risk.size());
    }
};

/// @in  confidence  (example), higher is surer
/// @in  wrong       (example), 1 where the answer is wrong, else 0
/// @eq  Geifman and El-Yaniv 2017, arXiv 1705.08500, section 2
RiskCoverage risk_coverage_of(std::span<const double> confidence,
                              std::span<const std::uint8_t> wrong);

/// Mean risk over all coverages, in [0, 1]; 0 where all is right.
/// @eq  Geifman, Uziel and El-Yaniv 2019, arXiv 1805.08206, section 2
double area_under_risk_coverage(const RiskCoverage& curve);

/// The largest share of examples that can be answered at a risk of at most `risk`; 0: none.
double coverage_at_risk(const RiskCoverage& curve, double risk);

}  // namespace specula
