#include "classifier/detection.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

std::vector<double> normals(std::size_t n, double mean, std::uint32_t item) {
    Stream stream({.seed = 6, .purpose = "detection test", .item = item});
    std::vector<double> values(n);
    for (double& value : values) value = mean + stream.normal();
    return values;
}

TEST_CASE("the area under the curve is the share of pairs in order, ties a half", "[detection]") {
    std::vector<double> familiar = normals(150, 0.0, 0), unfamiliar = normals(90, 0.8, 1);
    for (double& value : familiar) value = std::round(4.0 * value);  // many ties
    for (double& value : unfamiliar) value = std::round(4.0 * value);
    double in_order = 0.0;
    for (const double f : familiar)
        for (const double u : unfamiliar) in_order += u > f ? 1.0 : u == f ? 0.5 : 0.0;
    const Detection found = detection_of({familiar, unfamiliar});
    CHECK(found.auroc == Approx(in_order / (150.0 * 90.0)).epsilon(1e-14));
    CHECK(detection_of({unfamiliar, familiar}).auroc == Approx(1.0 - found.auroc).epsilon(1e-12));
}

TEST_CASE("of two normal clouds, the area is that of their distance", "[detection]") {
    const Detection found = detection_of({normals(4000, 0.0, 2), normals(4000, 1.5, 3)});
    const double expected = 0.5 * std::erfc(-1.5 / std::sqrt(2.0) / std::sqrt(2.0));
    CHECK(found.auroc == Approx(expected).margin(0.02));  // 4 standard errors (Hanley, McNeil)
    // Passing 95 % of the familiar ones is a limit of 1.645: 0.5576 of the others pass.
    CHECK(found.fpr95 == Approx(0.5 * std::erfc(-0.145 / std::sqrt(2.0))).margin(0.05));
}

TEST_CASE("the limit passes 95 of 100 familiar scores, and their equals", "[detection]") {
    std::vector<double> familiar;
    for (int i = 1; i <= 100; ++i) familiar.push_back(i);
    const std::vector<double> unfamiliar{94.0, 95.0, 95.5, 96.0};
    CHECK(detection_of({familiar, unfamiliar}).fpr95 == 0.5);
}

TEST_CASE("clouds apart are told apart, in whatever order they come", "[detection]") {
    const std::vector<double> low{3, 1, 2}, high{9, 7, 8};
    CHECK((detection_of({low, high}).auroc == 1.0 && detection_of({low, high}).fpr95 == 0.0));
    CHECK((detection_of({high, low}).auroc == 0.0 && detection_of({high, low}).fpr95 == 1.0));
}

}  // namespace
}  // namespace specula
