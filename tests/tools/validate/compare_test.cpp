#include "tools/validate/compare.hpp"

#include <limits>

#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST_CASE("the absolute error of complex numbers is their distance", "[validate]") {
    CHECK(absolute_error({{3.0, 4.0}, {0.0, 0.0}}) == 5.0);
    CHECK(absolute_error({{1.0, -2.0}, {1.0, -2.0}}) == 0.0);
    CHECK(std::isnan(absolute_error({nan, 1.0})));
}

TEST_CASE("a relative error is over the expected value, and over 1 where that is 0", "[validate]") {
    CHECK(relative_error({1.1, 1.0}) == Approx(0.1));
    CHECK(relative_error({-4.0, -2.0}) == 1.0);
    CHECK(relative_error({{0.0, 3.0}, {0.0, 2.0}}) == 0.5);
    CHECK(relative_error({1e-3, 0.0}) == 1e-3);
    CHECK(relative_error({0.0, 0.0}) == 0.0);
}

TEST_CASE("levels below the floor are all alike", "[validate]") {
    CHECK(level_error_db({-20.0, -23.5}) == 3.5);
    CHECK(level_error_db({-290.0, -310.0}, -150.0) == 0.0);
    CHECK(level_error_db({-149.0, -310.0}, -150.0) == 1.0);
    CHECK(level_error_db({-infinite, -infinite}) == 0.0);
    CHECK(std::isnan(level_error_db({nan, -10.0})));
    CHECK(std::isnan(level_error_db({-10.0, nan})));
}

TEST_CASE("amplitudes are compared by their level", "[validate]") {
    CHECK(amplitude_error_db({{0.0, 2.0}, {-1.0, 0.0}}) == Approx(20.0 * std::log10(2.0)));
}

TEST_CASE("angles are compared the short way round", "[validate]") {
    CHECK(wrapped_error({179.0, -179.0}, 360.0) == Approx(2.0));
    CHECK(wrapped_error({-725.0, -5.0}, 360.0) == Approx(0.0).margin(1e-12));
    CHECK(wrapped_error({0.0, 180.0}, 360.0) == 180.0);
    CHECK(wrapped_error({63.5, -0.5}, 64.0) == Approx(0.0).margin(1e-12));
    CHECK(std::isnan(wrapped_error({nan, 0.0}, 360.0)));
}

}  // namespace
}  // namespace specula
