#include "classifier/metrics.hpp"

#include <cmath>
#include <utility>

#include "sim/core/expect.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

Confusion confusion(std::size_t n, std::vector<std::int64_t> counts) {
    Confusion result(n);
    result.counts = std::move(counts);
    return result;
}

TEST_CASE("macro-F1 of a small table, by hand", "[metrics]") {
    const std::vector<std::uint8_t> truth{0, 1, 2, 0, 1, 2};
    const std::vector<std::uint8_t> predicted{0, 2, 1, 0, 0, 1};
    const Confusion table = confusion_of(truth, predicted, 3);
    CHECK(table.counts == std::vector<std::int64_t>{2, 0, 0, 1, 0, 1, 0, 2, 0});
    // Class 0: precision 2/3, recall 1, F1 4/5. Classes 1 and 2: never right.
    CHECK(macro_f1(table) == Approx(4.0 / 15.0).epsilon(1e-15));
}

TEST_CASE("macro-F1 is the harmonic mean of precision and recall, averaged", "[metrics]") {
    const Confusion table = confusion(3, {50, 3, 7, 10, 20, 0, 1, 2, 30});
    const double precisions[]{50.0 / 61, 20.0 / 25, 30.0 / 37};
    const double recalls[]{50.0 / 60, 20.0 / 30, 30.0 / 33};
    double expected = 0.0;
    for (int c = 0; c < 3; ++c) expected += 2.0 / (1.0 / precisions[c] + 1.0 / recalls[c]) / 3.0;
    CHECK(macro_f1(table) == Approx(expected).epsilon(1e-15));
    const auto recall = recall_per_class(table);
    for (std::size_t c = 0; c < 3; ++c) CHECK(recall[c].value() == Approx(recalls[c]));
}

TEST_CASE("all right is 1, all wrong is 0", "[metrics]") {
    CHECK(macro_f1(confusion(3, {5, 0, 0, 0, 1, 0, 0, 0, 9})) == 1.0);
    CHECK(macro_f1(confusion(2, {0, 5, 4, 0})) == 0.0);
}

TEST_CASE("classes that do not occur in the truth add no term", "[metrics]") {
    // Class 2 is never true but once predicted. F1 of 0: 2*3/(6+0+1), of 1: 1.
    const Confusion table = confusion(4, {3, 0, 1, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    CHECK(macro_f1(table) == Approx((6.0 / 7.0 + 1.0) / 2.0).epsilon(1e-15));
    const auto recall = recall_per_class(table);
    CHECK(recall[0].value() == 0.75);
    CHECK_FALSE(recall[2].has_value());
    CHECK_FALSE(recall[3].has_value());
    CHECK_THROWS_AS(macro_f1(Confusion(3)), BrokenPromise);
}

TEST_CASE("merging makes mistakes inside a group right and keeps all others", "[metrics]") {
    const Confusion table = confusion(3, {5, 4, 1, 3, 6, 0, 2, 1, 7});
    const std::vector<int> metals_together{0, 0, 1};
    const Confusion merged = merge_classes(table, metals_together);
    CHECK(merged.counts == std::vector<std::int64_t>{18, 1, 3, 7});
    const std::vector<int> none{0, 1, 2};
    CHECK(merge_classes(table, none).counts == table.counts);
}

TEST_CASE("a bootstrap of one world, or of equal worlds, is a point", "[metrics]") {
    const StreamKey key{.seed = 1, .purpose = "metrics test"};
    const Interval one = bootstrap_mean({0.25}, key);
    CHECK((one.mean == 0.25 && one.low == 0.25 && one.high == 0.25));
    const Interval equal = bootstrap_mean({0.5, 0.5, 0.5}, key);
    CHECK((equal.mean == 0.5 && equal.low == 0.5 && equal.high == 0.5));
}

TEST_CASE("the bootstrap of many worlds approaches the normal interval", "[metrics]") {
    Stream stream({.seed = 2, .purpose = "metrics test"});
    std::vector<double> worlds(400);
    for (double& world : worlds) world = 0.7 + 0.1 * stream.normal();
    double mean = 0.0, variance = 0.0;
    for (const double world : worlds) mean += world / 400.0;
    for (const double world : worlds) variance += (world - mean) * (world - mean) / 400.0;
    const double half_width = 1.959964 * std::sqrt(variance / 400.0);
    const Interval interval = bootstrap_mean(worlds, {.seed = 3, .purpose = "metrics test"});
    CHECK(interval.mean == Approx(mean).epsilon(1e-12));
    // A 2.5 % quantile of 10,000 draws has a standard error of 0.027 of their spread.
    CHECK(interval.low == Approx(mean - half_width).margin(0.06 * half_width));
    CHECK(interval.high == Approx(mean + half_width).margin(0.06 * half_width));
}

TEST_CASE("of two worlds, the interval is all they span", "[metrics]") {
    // Both draws of one world: a quarter of the resamples on either side, far beyond 2.5 %.
    const Interval interval = bootstrap_mean({0.2, 0.6}, {.seed = 1, .purpose = "metrics test"});
    CHECK(interval.mean == Approx(0.4));
    CHECK(interval.low == 0.2);
    CHECK(interval.high == 0.6);
}

TEST_CASE("the same key resamples the same worlds", "[metrics]") {
    const std::vector<double> worlds{0.1, 0.5, 0.2, 0.9, 0.4};
    std::vector<double> shifted = worlds;
    for (double& world : shifted) world += 1.0;
    const StreamKey key{.seed = 1, .purpose = "metrics test"};
    const Interval interval = bootstrap_mean(worlds, key);
    const Interval other = bootstrap_mean(shifted, key);
    CHECK(other.low == Approx(interval.low + 1.0).epsilon(1e-14));
    CHECK(other.high == Approx(interval.high + 1.0).epsilon(1e-14));
}

TEST_CASE("a share over equal worlds has the interval of the mean of their shares", "[metrics]") {
    const StreamKey key{.seed = 3, .purpose = "share"};
    const std::vector<double> parts{2, 4, 5, 9}, wholes{10, 10, 10, 10};
    const Interval share = bootstrap_share(parts, wholes, key);
    const Interval mean = bootstrap_mean({0.2, 0.4, 0.5, 0.9}, key);
    CHECK(share.mean == Approx(mean.mean));
    CHECK(share.low == Approx(mean.low));
    CHECK(share.high == Approx(mean.high));
    // A world that counts nothing changes no share, and no resample of it alone is 0 / 0.
    const Interval with_empty = bootstrap_share({2, 0}, {10, 0}, key);
    CHECK(with_empty.low == Approx(0.2));
    CHECK(with_empty.high == Approx(0.2));
}

}  // namespace
}  // namespace specula
