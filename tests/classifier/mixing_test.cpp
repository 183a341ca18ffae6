#include "classifier/mixing.hpp"

#include <vector>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("mixing shares have the mean and the variance of a symmetric beta law", "[mixup]") {
    const double shape = GENERATE(0.05, 0.2, 0.5, 1.0);
    Stream stream({.seed = 4, .purpose = "mixing test"});
    constexpr int n = 20000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < n; ++i) {
        const double share = mixing_share(shape, stream);
        REQUIRE((share >= 0.0 && share <= 1.0));
        sum += share - 0.5;
        squares += (share - 0.5) * (share - 0.5);
    }
    CAPTURE(shape);
    const double variance = 1.0 / (4.0 * (2.0 * shape + 1.0));
    // Four standard errors: of the mean, and of the variance (whose values spread less than 1/8).
    CHECK(sum / n == Approx(0.0).margin(4.0 * std::sqrt(variance / n)));
    CHECK(squares / n == Approx(variance).margin(4.0 * 0.125 / std::sqrt(double(n))));
}

}  // namespace
}  // namespace specula
