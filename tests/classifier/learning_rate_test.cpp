#include "classifier/learning_rate.hpp"

#include <algorithm>
#include <cmath>

#include "tests/check.hpp"

namespace specula {
namespace {

double rate(Schedule schedule, std::int64_t step, std::int64_t n_steps) {
    return learning_rate_at({.schedule = schedule, .peak = 0.01, .step = step, .n_steps = n_steps});
}

TEST_CASE("a cosine begins at the peak, is half of it half way and falls all along", "[schedule]") {
    CHECK(rate(Schedule::cosine, 0, 100) == 0.01);
    CHECK(rate(Schedule::cosine, 50, 100) == Approx(0.005).epsilon(1e-14));
    // The last of 100 steps is one hundredth of half a turn before the end: (pi/100)^2 / 4.
    CHECK(rate(Schedule::cosine, 99, 100) == Approx(0.01 * 2.467e-4).epsilon(1e-3));
    for (int step = 1; step < 100; ++step)
        REQUIRE(rate(Schedule::cosine, step, 100) < rate(Schedule::cosine, step - 1, 100));
}

TEST_CASE("one cycle has the numbers that torch's OneCycleLR prints", "[schedule]") {
    // torch 1.13, OneCycleLR(max_lr=0.01, total_steps=10), by hand: up over steps 0 to 2, down
    // over 2 to 9, both along half a cosine; div_factor 25, final_div_factor 1e4.
    const double start = 0.01 / 25.0, end = start / 1e4;
    const auto between = [](double from, double to, double share) {
        return to + (from - to) / 2.0 * (std::cos(std::acos(-1.0) * share) + 1.0);
    };
    CHECK(rate(Schedule::one_cycle, 0, 10) == Approx(start).epsilon(1e-14));
    CHECK(rate(Schedule::one_cycle, 1, 10) == Approx((start + 0.01) / 2.0).epsilon(1e-14));
    CHECK(rate(Schedule::one_cycle, 2, 10) == Approx(0.01).epsilon(1e-14));
    for (int step = 3; step < 9; ++step)
        CHECK(rate(Schedule::one_cycle, step, 10) ==
              Approx(between(0.01, end, (step - 2) / 7.0)).epsilon(1e-12));
    CHECK(rate(Schedule::one_cycle, 9, 10) == Approx(end).epsilon(1e-9));
}

TEST_CASE("no schedule leaves the interval from nothing to the peak, however short", "[schedule]") {
    const auto schedule = GENERATE(Schedule::constant, Schedule::cosine, Schedule::one_cycle);
    for (std::int64_t n = 1; n < 60; ++n)
        for (std::int64_t step = 0; step < n; ++step) {
            const double value = rate(schedule, step, n);
            REQUIRE(value > 0.0);
            REQUIRE(value <= 0.01 * (1.0 + 1e-15));
        }
    CHECK(rate(Schedule::constant, 7, 9) == 0.01);
}

}  // namespace
}  // namespace specula
