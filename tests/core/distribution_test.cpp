#include "sim/core/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/check.hpp"

namespace specula {
namespace {

constexpr int n_draws = 40'000;

std::vector<double> sorted_draws(const Distribution& law) {
    Stream stream({.seed = 11, .purpose = "draws"});
    std::vector<double> values(n_draws);
    for (double& value : values) value = law.sample(stream);
    std::sort(values.begin(), values.end());
    return values;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST_CASE("a fixed value is drawn as it is and has no spread", "[distribution]") {
    const Distribution law = 0.45;
    const auto values = sorted_draws(law);
    CHECK(values.front() == 0.45);
    CHECK(values.back() == 0.45);
    CHECK(law.median() == 0.45);
    CHECK(law.spread() == 0.0);
}

TEST_CASE("a uniform law fills its interval and stays in it", "[distribution]") {
    const Distribution law(Distribution::Uniform{-2.0, 6.0});
    const auto values = sorted_draws(law);
    CHECK(values.front() > -2.0);
    CHECK(values.back() < 6.0);
    // The outermost of n draws miss the ends by about 1/n; ten times that has probability e^-10.
    CHECK(values.front() < -2.0 + 8.0 * 10.0 / n_draws);
    CHECK(values.back() > 6.0 - 8.0 * 10.0 / n_draws);
    CHECK(law.median() == 2.0);
    CHECK(law.spread() == Approx(8.0 / std::sqrt(12.0)));
    const double five_errors = 5.0 * law.spread() / std::sqrt(n_draws);
    CHECK(std::abs(mean_of(values) - 2.0) < five_errors);
    CHECK(std::abs(deviation_of(values) - law.spread()) < five_errors);
}

TEST_CASE("a normal law has its mean and standard deviation", "[distribution]") {
    const Distribution law(Distribution::Normal{0.01, 0.002});
    const auto values = sorted_draws(law);
    const double five_errors = 5.0 * 0.002 / std::sqrt(n_draws);
    CHECK(law.median() == 0.01);
    CHECK(law.spread() == 0.002);
    CHECK(std::abs(mean_of(values) - 0.01) < five_errors);
    CHECK(std::abs(deviation_of(values) - 0.002) < five_errors);
}

TEST_CASE("a factor law is positive, and as often above its median as below", "[distribution]") {
    const Distribution law(Distribution::Factor{5.0, 1.5});
    const auto values = sorted_draws(law);
    CHECK(values.front() > 0.0);
    CHECK(law.median() == 5.0);
    CHECK(law.spread() == Approx(std::log(1.5)));
    // Five standard errors of an empirical quantile, 1.25 sd / sqrt(n) of the logarithm.
    const double tolerance = 5.0 * 1.2534 * std::log(1.5) / std::sqrt(n_draws);
    CHECK(std::abs(std::log(values[n_draws / 2] / 5.0)) < tolerance);
    // One standard deviation is a factor of 1.5: 15.87 % lie above 7.5.
    const auto above = values.end() - std::upper_bound(values.begin(), values.end(), 7.5);
    const double share = 0.5 * std::erfc(1.0 / std::sqrt(2.0));
    CHECK(std::abs(static_cast<double>(above) / n_draws - share) <
          5.0 * std::sqrt(share * (1.0 - share) / n_draws));
}

TEST_CASE("a choice gives each of its values as often, and nothing else", "[distribution]") {
    const Distribution law(Distribution::Choice{{3.0, 4.0, 6.0, 8.0}});
    std::map<double, int> times;
    for (const double value : sorted_draws(law)) ++times[value];
    CHECK(times.size() == 4);
    for (const double value : {3.0, 4.0, 6.0, 8.0})  // five standard errors of a quarter
        CHECK(std::abs(times[value] - n_draws / 4) < 5.0 * std::sqrt(n_draws * 0.25 * 0.75));
    CHECK(law.median() == 4.0);
    CHECK(law.spread() ==
          Approx(std::sqrt((2.25 * 2.25 + 1.25 * 1.25 + 0.75 * 0.75 + 2.75 * 2.75) / 4)));
}

TEST_CASE("a quantile is the inverse of the share below it", "[distribution]") {
    const Distribution normal(Distribution::Normal{1.0, 2.0});
    for (const double u : {1e-9, 0.01, 0.3, 0.5, 0.8, 0.999999}) {
        const double below = 0.5 * std::erfc(-(normal.quantile(u) - 1.0) / 2.0 / std::sqrt(2.0));
        CHECK(below == Approx(u).epsilon(1e-12));
    }
    // Abramowitz and Stegun, table 26.5: Phi(1.959964) = 0.975.
    CHECK(normal.quantile(0.975) == Approx(1.0 + 2.0 * 1.959963985).epsilon(1e-9));
    CHECK(Distribution(Distribution::Uniform{2.0, 6.0}).quantile(0.25) == 3.0);
    CHECK(Distribution(Distribution::Factor{5.0, 1.5}).quantile(0.5) == Approx(5.0));
    CHECK(Distribution(Distribution::Factor{5.0, 1.5}).quantile(0.8413447461) == Approx(7.5));
    CHECK(Distribution(Distribution::Choice{{7.0, 8.0}}).quantile(0.49) == 7.0);
    CHECK(Distribution(Distribution::Choice{{7.0, 8.0}}).quantile(0.51) == 8.0);
    CHECK(Distribution(9.0).quantile(0.3) == 9.0);
}

TEST_CASE("laws without spread give their median exactly", "[distribution]") {
    for (const Distribution& law : {Distribution(Distribution::Uniform{3.0, 3.0}),
                                    Distribution(Distribution::Normal{3.0, 0.0}),
                                    Distribution(Distribution::Factor{3.0, 1.0})}) {
        Stream stream({.seed = 1, .purpose = "no spread"});
        CHECK(law.sample(stream) == 3.0);
        CHECK(law.spread() == 0.0);
    }
}

TEST_CASE("changing one law changes no later draw", "[distribution]") {
    const Distribution laws[]{Distribution(1.0), Distribution(Distribution::Uniform{0.0, 1.0}),
                              Distribution(Distribution::Normal{0.0, 1.0}),
                              Distribution(Distribution::Factor{1.0, 2.0}),
                              Distribution(Distribution::Choice{{1.0, 2.0}})};
    std::vector<std::vector<double>> after;
    for (const Distribution& law : laws) {
        Stream stream({.seed = 2, .purpose = "order"});
        std::vector<double> draws;
        for (int i = 0; i < 5; ++i) {
            (void)law.sample(stream);
            draws.push_back(stream.normal());
        }
        after.push_back(draws);
    }
    for (const auto& draws : after) CHECK(draws == after.front());
}

}  // namespace
}  // namespace specula
