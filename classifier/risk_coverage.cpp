#include "classifier/risk_coverage.hpp"

#include <algorithm>
#include <numeric>

#include "sim/core/expect.hpp"

namespace specula {

RiskCoverage risk_coverage_of(std::span<const double> confidence,
                              std::span<const std::uint8_t> wrong) {
    SPECULA_EXPECT(!wrong.empty() && confidence.size() == wrong.size());
    std::vector<std::size_t> order(wrong.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return confidence[a] > confidence[b]; });
    RiskCoverage curve;
    curve.risk.reserve(wrong.size());
    double n_wrong = 0.0;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        double among_equals = 0.0;
        while (end < order.size() && confidence[order[end]] == confidence[order[begin]])
            among_equals += wrong[order[end++]] ? 1.0 : 0.0;
        const double each = among_equals / static_cast<double>(end - begin);
        for (std::size_t k = begin; k < end; ++k) {
            const auto n_before = static_cast<double>(k - begin + 1);
            curve.risk.push_back((n_wrong + each * n_before) / static_cast<double>(k + 1));
        }
        n_wrong += among_equals;
        begin = end;
    }
    return curve;
}

double area_under_risk_coverage(const RiskCoverage& curve) {
    SPECULA_EXPECT(!curve.risk.empty());
    return std::accumulate(curve.risk.begin(), curve.risk.end(), 0.0) /
           static_cast<double>(curve.risk.size());
}

double coverage_at_risk(const RiskCoverage& curve, double risk) {
    for (std::size_t k = curve.risk.size(); k-- > 0;)
        if (curve.risk[k] <= risk) return curve.coverage(k);
    return 0.0;
}

}  // namespace specula
