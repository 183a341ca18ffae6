#include "sim/trace/patch.hpp"

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double wavelength_m = 0.005;
const AntennaPair overhead{{0.0, 0.0, 0.45}, {0.0, 0.0, 0.45}};

PointCount needed(const Plate& plate, const Patch& patch, double at_wavelength_m) {
    const PlateView view{plate, {}, {.shift_m = {0.0, 0.0, 0.45}}};
    return points_needed(view, overhead, patch, at_wavelength_m);
}

const Patch whole{{-0.15, 0.15}, {-0.15, 0.15}};

TEST_CASE("a patch much smaller than a wavelength needs only the few points on top", "[trace]") {
    const PointCount count = needed({}, {{0.0, 1e-5}, {0.0, 1e-5}}, wavelength_m);
    CHECK(count.x <= 9);
    CHECK(count.y <= 9);
}

TEST_CASE("points grow with the number of wavelengths on the path", "[trace]") {
    const int few = needed({}, whole, wavelength_m).x - 8;
    for (const int times : {2, 3, 10}) {
        const int many = needed({}, whole, wavelength_m / times).x - 8;
        CHECK(std::abs(many - times * few) <= times);  // each count is rounded up
    }
}

TEST_CASE("each turn of the phase gets two points where it turns fastest", "[trace]") {
    // Straight down on the foot's side: the path changes by 2 x/r per metre; over u in [-1, 1] the
    // points lie n / (pi sqrt(1 - u^2)) dense.
    double densest = 0.0;
    for (double u = 0.0; u < 1.0; u += 1e-3) {
        const double x_m = 0.15 * u;
        const double turns_per_u = 2.0 * x_m / std::hypot(x_m, 0.45) * 0.15 / wavelength_m;
        densest = std::max(densest, 2.0 * turns_per_u * pi * std::sqrt(1.0 - u * u));
    }
    const double found = needed({}, whole, wavelength_m).x - 8;
    CHECK(found >= 0.95 * densest);  // looks are taken at 9 places, so the top may be missed by 5 %
    CHECK(found <= densest + 1.0);
}

TEST_CASE("a wide axis needs more points than a narrow one", "[trace]") {
    const PointCount count = needed({}, {{-0.15, 0.15}, {-0.05, 0.05}}, wavelength_m);
    CHECK(count.x > 2 * count.y);
}

TEST_CASE("a patch maps -1 to 1 onto itself", "[trace]") {
    const Patch patch{{-0.1, 0.3}, {0.2, 0.25}};
    CHECK(patch.x_at(-1.0) == Approx(-0.1).margin(1e-15));
    CHECK(patch.x_at(1.0) == Approx(0.3));
    CHECK(patch.x_at(0.0) == Approx(0.1));
    CHECK(patch.y_at(1.0) == Approx(0.25));
}

}  // namespace
}  // namespace specula
