#include "firmware/fw_monitor.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

/// A spread in two dimensions: S = [[4, 2], [2, 5]], whose whitening is worked by hand.
/// L = [[2, 0], [1, 2]], W = L^-1 = [[1/2, 0], [-1/4, 1/2]].
struct Plane {
    std::array<float, 2> mean{10, 20};
    std::array<float, 3> whitening{0.5F, -0.25F, 0.5F};
    std::array<float, 4> centre{0, 0, 3, 4};  // the second class lies at L (3, 4) = (6, 11)
    fw_mahalanobis monitor{2, 2, mean.data(), whitening.data(), centre.data()};

    float squared(float x, float y) const {
        const std::array<float, 2> features{x, y};
        float result = -1;
        REQUIRE(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_OK);
        return result;
    }
};

}  // namespace

TEST_CASE("the distance is that of the inverse covariance, from the nearest class", "[firmware]") {
    const Plane plane;
    // S^-1 = [[5, -2], [-2, 4]] / 16
    const auto by_definition = [](double x, double y) {
        return (5 * x * x - 4 * x * y + 4 * y * y) / 16;
    };
    for (double x = -6; x <= 12; x += 1.5) {
        for (double y = -6; y <= 17; y += 1.5) {
            const double expected = std::min(by_definition(x, y), by_definition(x - 6, y - 11));
            CHECK(plane.squared(static_cast<float>(10 + x), static_cast<float>(20 + y)) ==
                  Approx(expected).margin(1e-4));
        }
    }
    CHECK(plane.squared(10, 20) == 0.0F);
    CHECK(plane.squared(16, 31) == 0.0F);
}

TEST_CASE("the energy is minus the logarithm of the sum of exponentials", "[firmware]") {
    for (unsigned seed = 0; seed < 50; ++seed) {
        auto logits = oracle::random_values(5, seed);
        double sum = 0;
        for (auto& logit : logits) sum += std::exp(static_cast<double>(logit *= 20));
        float energy = 0;
        REQUIRE(fw_energy(logits.data(), 5, &energy) == FW_OK);
        CHECK(energy == Approx(-std::log(sum)).margin(4e-6));
    }
    const std::array<float, 2> far{3e38F, -3e38F};
    float energy = 0;
    REQUIRE(fw_energy(far.data(), 2, &energy) == FW_OK);
    CHECK(energy == -3e38F);
}

TEST_CASE("the largest logit is found, and nothing gives 0", "[firmware]") {
    const std::array<float, 3> logits{-3, -1, -2};
    CHECK(fw_max_logit(logits.data(), 3) == -1.0F);
    CHECK(fw_max_logit(logits.data(), 0) == 0.0F);
    CHECK(fw_max_logit(nullptr, 3) == 0.0F);
}

TEST_CASE("monitors refuse what is missing, empty or not finite", "[firmware]") {
    const Plane plane;
    auto monitor = plane.monitor;
    std::array<float, 2> features{1, oracle::not_a_number};
    float result = -1;
    CHECK(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_ERR_NONFINITE);
    features = {3e38F, -3e38F};
    CHECK(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_ERR_NONFINITE);
    monitor.n_features = FW_MAHALANOBIS_MAX_FEATURES + 1;
    CHECK(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_ERR_SHAPE);
    monitor = plane.monitor;
    monitor.n_classes = 0;
    CHECK(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_ERR_SHAPE);
    monitor.mean = nullptr;
    CHECK(fw_mahalanobis_squared(&monitor, features.data(), &result) == FW_ERR_NULL);
    CHECK(fw_energy(features.data(), 0, &result) == FW_ERR_SHAPE);
    CHECK(fw_energy(nullptr, 2, &result) == FW_ERR_NULL);
    features = {1, oracle::not_a_number};
    CHECK(fw_energy(features.data(), 2, &result) == FW_ERR_NONFINITE);
    CHECK(result == -1.0F);
}

TEST_CASE("one suspicious frame raises no alarm, many do, and it takes as many good ones to end it",
          "[firmware]") {
    fw_drift drift{.rise = 4, .fall = 1, .limit = 40, .level = 0, .alarm = false};
    CHECK_FALSE(fw_drift_update(&drift, true));
    for (int i = 0; i < 8; ++i) CHECK_FALSE(fw_drift_update(&drift, true));
    CHECK(fw_drift_update(&drift, true));
    for (int i = 0; i < 39; ++i) CHECK(fw_drift_update(&drift, false));
    CHECK_FALSE(fw_drift_update(&drift, false));
    CHECK_FALSE(fw_drift_update(nullptr, true));
}

TEST_CASE("a share of suspicious frames below fall / (rise + fall) never alarms, one above does",
          "[firmware]") {
    // fall / (rise + fall) = 0.2: one in six stays silent, one in four does not.
    for (const int every : {6, 4}) {
        fw_drift drift{.rise = 4, .fall = 1, .limit = 60000, .level = 0, .alarm = false};
        bool alarm = false;
        for (int i = 0; i < 300000; ++i) alarm = fw_drift_update(&drift, i % every == 0) || alarm;
        CHECK(alarm == (every == 4));
    }
}
