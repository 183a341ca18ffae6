#include "classifier/drift.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

struct Cloud {
    std::size_t n = 400;
    double mean = 0.0;
    double sd = 1.0;
    std::uint32_t item = 0;
};

FeatureTable cloud(const Cloud& law) {
    Stream stream({.seed = 8, .purpose = "drift test", .item = law.item});
    FeatureTable table;
    table.n_features = 2;
    for (std::size_t i = 0; i < law.n; ++i) {
        table.features.push_back(static_cast<float>(law.mean + law.sd * stream.normal()));
        table.features.push_back(static_cast<float>(stream.normal()));
        table.label.push_back(0);
    }
    return table;
}

TEST_CASE("the stability index of moved normals is their symmetric divergence", "[drift]") {
    // Over ten bins of equal share, summed plainly from the normal law.
    const double moved = GENERATE(0.25, 0.5, 1.0);
    const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
    const double edges[]{-1.281552, -0.841621, -0.524401, -0.253347, 0.0,
                         0.253347,  0.524401,  0.841621,  1.281552};
    double expected = 0.0, last = 0.0;
    for (int b = 0; b < 10; ++b) {
        const double upto = b < 9 ? below(edges[b] - moved) : 1.0;
        expected += (upto - last - 0.1) * std::log((upto - last) / 0.1);
        last = upto;
    }
    const auto index =
        population_stability({cloud({.n = 20000}), cloud({.n = 20000, .mean = moved, .item = 1})});
    // Four standard deviations: 2 sqrt(expected (1 / n + 1 / m)) each.
    CHECK(index[0] == Approx(expected).margin(8.0 * std::sqrt(expected * 1e-4)));
    CHECK(index[1] < 0.005);  // 18 / n of chance (twice nine degrees of freedom), times five
}

TEST_CASE("drift of a table from itself is none", "[drift]") {
    const FeatureTable same = cloud({});
    CHECK(population_stability({same, same}) == std::vector<double>{0.0, 0.0});
    CHECK(mean_shift({same, same}) == std::vector<double>{0.0, 0.0});
}

TEST_CASE("a feature that leaves its range altogether has a large, finite index", "[drift]") {
    const auto index = population_stability({cloud({}), cloud({.mean = 50.0, .item = 1})});
    CHECK((index[0] > 2.0 && std::isfinite(index[0])));
}

TEST_CASE("the mean shift is in standard deviations of the familiar rows", "[drift]") {
    const auto shift =
        mean_shift({cloud({.n = 5000, .sd = 2.0}), cloud({.n = 5000, .mean = 3.0, .item = 1})});
    CHECK(shift[0] == Approx(1.5).margin(0.06));  // 4 standard errors
    CHECK(shift[1] < 0.08);

    FeatureTable constant = cloud({}), moved = cloud({.item = 1});
    for (std::size_t i = 0; i < constant.size(); ++i) constant.features[2 * i] = 5.0f;
    for (std::size_t i = 0; i < moved.size(); ++i) moved.features[2 * i] = 6.0f;
    CHECK(std::isfinite(mean_shift({constant, moved})[0]));
    CHECK(mean_shift({constant, moved})[0] > 1e4);
}

/// The unbiased estimate by four plain loops over pairs.
double plain_discrepancy(const FeatureTable& a, const FeatureTable& b) {
    std::vector<double> mean(2), sd(2);
    const auto n = static_cast<double>(a.size());
    for (std::size_t f = 0; f < 2; ++f) {
        for (std::size_t i = 0; i < a.size(); ++i) mean[f] += double(a.row(i)[f]) / n;
        for (std::size_t i = 0; i < a.size(); ++i)
            sd[f] += (double(a.row(i)[f]) - mean[f]) * (double(a.row(i)[f]) - mean[f]) / n;
        sd[f] = std::sqrt(sd[f]);
    }
    std::vector<std::pair<double, double>> all;
    for (const FeatureTable* table : {&a, &b})
        for (std::size_t i = 0; i < table->size(); ++i)
            all.emplace_back((double(table->row(i)[0]) - mean[0]) / sd[0],
                             (double(table->row(i)[1]) - mean[1]) / sd[1]);
    const auto squared = [&](std::size_t i, std::size_t j) {
        const double x = all[i].first - all[j].first, y = all[i].second - all[j].second;
        return x * x + y * y;
    };
    std::vector<double> pairs;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j) pairs.push_back(squared(i, j));
    std::sort(pairs.begin(), pairs.end());
    const double median = pairs[pairs.size() / 2];
    double sum = 0.0;
    const double m = double(a.size()), k = double(b.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < all.size(); ++j) {
            if (i == j) continue;
            const bool i_in_a = i < a.size(), j_in_a = j < a.size();
            const double weight = i_in_a != j_in_a ? -1.0 / (m * k)
                                  : i_in_a         ? 1.0 / (m * (m - 1.0))
                                                   : 1.0 / (k * (k - 1.0));
            sum += weight * std::exp(-squared(i, j) / (2.0 * median));
        }
    return sum;
}

TEST_CASE("the discrepancy is its definition, summed plainly", "[drift]") {
    const FeatureTable a = cloud({.n = 60}), b = cloud({.n = 45, .mean = 0.7, .item = 1});
    CHECK(mean_discrepancy({a, b}) == Approx(plain_discrepancy(a, b)).epsilon(1e-10));
}

TEST_CASE("the discrepancy of one law is about nothing, and grows with the shift", "[drift]") {
    const FeatureTable nominal = cloud({});
    const double none = mean_discrepancy({nominal, cloud({.item = 1})});
    const double some = mean_discrepancy({nominal, cloud({.mean = 0.5, .item = 1})});
    const double much = mean_discrepancy({nominal, cloud({.mean = 3.0, .item = 1})});
    CHECK(std::abs(none) < 0.01);  // of the order of 1 / n
    // By the kernel's integral over two normals, 0.030 and more than 0.6.
    CHECK((some > 0.012 && much > 5.0 * some));
    CHECK(mean_discrepancy({nominal, nominal}, {.max_rows = 100}) < 0.0);  // unbiased: below 0
}

}  // namespace
}  // namespace specula
