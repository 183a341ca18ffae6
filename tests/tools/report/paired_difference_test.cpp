#include "tools/report/paired_difference.hpp"

#include "tests/check.hpp"

using namespace specula;

TEST_CASE("a constant difference has an interval of no width", "[report]") {
    const auto d = paired_difference({0.5, 0.7, 0.9}, {0.6, 0.8, 1.0}, 1);
    CHECK(d.value.low == Approx(-0.1).margin(1e-12));  // rounding of the sums
    CHECK(d.value.high == Approx(-0.1).margin(1e-12));
    CHECK(d.n_below == 3);
    CHECK(d.is_clear());
    CHECK(difference_text(d) == "lower by 10.0\u00a0points (95\u00a0% interval 10.0 to 10.0)");
}

TEST_CASE("pairing removes what worlds have in common", "[report]") {
    const std::vector<double> a{0.20, 0.50, 0.80, 0.95}, b{0.18, 0.47, 0.78, 0.92};
    CHECK(paired_difference(a, b, 1).is_clear());
}

TEST_CASE("no effect is claimed when the interval includes zero", "[report]") {
    const auto d = paired_difference({0.5, 0.6, 0.4, 0.5}, {0.6, 0.5, 0.5, 0.39}, 1);
    CHECK_FALSE(d.is_clear());
    CHECK(difference_text(d).starts_with("not clearly different"));
}

TEST_CASE("one world gives a difference but no interval", "[report]") {
    const auto d = paired_difference({0.5}, {0.4}, 1);
    CHECK_FALSE(d.is_clear());
    CHECK(difference_text(d) == "higher by 10.0\u00a0points (one world: no interval)");
}

TEST_CASE("the bootstrap depends on the seed alone", "[report]") {
    const std::vector<double> a{0.2, 0.5, 0.8, 0.9, 0.4}, b{0.1, 0.6, 0.7, 0.7, 0.45};
    const auto one = paired_difference(a, b, 7), two = paired_difference(a, b, 7);
    CHECK(one.value.low == two.value.low);
    CHECK(one.value.high == two.value.high);
}
