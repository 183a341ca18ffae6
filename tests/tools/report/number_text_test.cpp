#include "tools/report/number_text.hpp"

#include <limits>

#include "tests/check.hpp"

using namespace specula;

TEST_CASE("shares are written as percentages with one decimal", "[report]") {
    CHECK(percent_text(0.942) == "94.2\u00a0%");
    CHECK(points_text(-0.016) == "\u22121.6\u00a0points");
    CHECK(points_text(0.01) == "1.0\u00a0point");
    CHECK(range_text({.mean = 0.5, .low = 0.4, .high = 0.625}) == "40.0 to 62.5\u00a0%");
}

TEST_CASE("zero has no sign, and what is no number shows as a dash", "[report]") {
    CHECK(fixed_text(-0.04, 1) == "0.0");
    CHECK(signed_text(0.04, 1) == "0.0");
    CHECK(signed_text(2.4, 1) == "+2.4");
    CHECK(signed_text(-2.4, 1) == "\u22122.4");
    CHECK(fixed_text(std::numeric_limits<double>::quiet_NaN(), 1) == "\u2013");
}

TEST_CASE("counts of five digits and more are grouped by threes", "[report]") {
    CHECK(count_text(0) == "0");
    CHECK(count_text(9999) == "9999");
    CHECK(count_text(96000) == "96\u00a0000");
    CHECK(count_text(1234567) == "1\u00a0234\u00a0567");
}
