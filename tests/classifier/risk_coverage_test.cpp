#include "classifier/risk_coverage.hpp"

#include <algorithm>
#include <numeric>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("risk over coverage of four examples, by hand", "[risk]") {
    const std::vector<double> confidence{0.9, 0.2, 0.7, 0.4};
    const std::vector<std::uint8_t> wrong{0, 1, 1, 0};
    const RiskCoverage curve = risk_coverage_of(confidence, wrong);
    CHECK(curve.risk == std::vector<double>{0.0, 0.5, 1.0 / 3.0, 0.5});
    CHECK(area_under_risk_coverage(curve) == Approx((0.0 + 0.5 + 1.0 / 3.0 + 0.5) / 4.0));
    CHECK(coverage_at_risk(curve, 0.05) == 0.25);
    CHECK(coverage_at_risk(curve, 0.4) == 0.75);  // the larger of the coverages that do
    CHECK(coverage_at_risk(curve, 0.5) == 1.0);
}

TEST_CASE("equally sure examples count as the mean over their orders", "[risk]") {
    const std::vector<double> confidence{1.0, 1.0, 1.0, 0.5};
    const std::vector<std::uint8_t> wrong{1, 0, 0, 1};
    std::vector<double> mean(4, 0.0);
    std::vector<std::size_t> order{0, 1, 2};
    do {
        double n_wrong = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            n_wrong += wrong[k < 3 ? order[k] : 3];
            mean[k] += n_wrong / static_cast<double>(k + 1) / 6.0;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    const RiskCoverage curve = risk_coverage_of(confidence, wrong);
    for (std::size_t k = 0; k < 4; ++k) CHECK(curve.risk[k] == Approx(mean[k]).epsilon(1e-14));
}

TEST_CASE("confidence that says nothing has the error rate everywhere", "[risk]") {
    const std::vector<double> same(50, 0.3);
    std::vector<std::uint8_t> wrong(50, 0);
    std::fill(wrong.begin(), wrong.begin() + 10, std::uint8_t{1});
    const RiskCoverage curve = risk_coverage_of(same, wrong);
    CHECK(area_under_risk_coverage(curve) == Approx(0.2).epsilon(1e-14));
    CHECK(coverage_at_risk(curve, 0.19) == 0.0);
}

TEST_CASE("a perfect order leaves the area of a late rise, a reversed one the largest", "[risk]") {
    constexpr std::size_t n = 200, n_wrong = 50;
    std::vector<double> confidence(n);
    std::iota(confidence.begin(), confidence.end(), 0.0);
    std::vector<std::uint8_t> wrong(n, 0);
    std::fill(wrong.begin(), wrong.begin() + n_wrong, std::uint8_t{1});
    double best = 0.0, worst = 0.0;
    for (std::size_t k = 1; k <= n; ++k) {
        best += (k > n - n_wrong ? double(k - (n - n_wrong)) / double(k) : 0.0) / n;
        worst += double(std::min(k, n_wrong)) / double(k) / n;
    }
    CHECK(area_under_risk_coverage(risk_coverage_of(confidence, wrong)) == Approx(best));
    std::reverse(confidence.begin(), confidence.end());
    CHECK(area_under_risk_coverage(risk_coverage_of(confidence, wrong)) == Approx(worst));
}

}  // namespace
}  // namespace specula
