#include "sim/trace/quadrature.hpp"

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double wavelength_m = 0.005;
const PhaseCentres overhead{{0.0, 0.0, 0.45}, {0.0, 0.0, 0.45}};

PointCount needed(const Plate& plate, double at_wavelength_m, double accuracy_db) {
    return points_needed(PlateSurface{plate, {}}, {}, overhead, at_wavelength_m, accuracy_db);
}

TEST_CASE("a plate much smaller than a wavelength needs one point", "[trace]") {
    const PointCount count = needed({1e-4, 1e-4}, wavelength_m, 0.1);
    CHECK(count.u == 1);
    CHECK(count.v == 1);
}

TEST_CASE("points grow with the number of wavelengths on the path", "[trace]") {
    const int once = needed({}, wavelength_m, 0.1).u;
    for (const int times : {2, 4}) {
        const int many = needed({}, wavelength_m / times, 0.1).u;
        CHECK(many > times * once / 2);
        CHECK(many < times * once);  // what comes on top grows with the cube root only
    }
}

TEST_CASE("accuracy costs points by its logarithm only", "[trace]") {
    const int rough = needed({}, wavelength_m, 1.0).u;
    const int fine = needed({}, wavelength_m, 1e-6).u;
    CHECK(fine > rough);
    CHECK(fine < rough + 20);
}

TEST_CASE("a wide axis needs more points than a narrow one", "[trace]") {
    const PointCount count = needed({0.3, 0.1}, wavelength_m, 0.1);
    CHECK(count.u > count.v);
}

TEST_CASE("a triangle's points integrate its area", "[trace]") {
    const TriangleSurface triangle{{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.0, 0.2, 0.1}};
    // Midpoints in u see the mean of an area element that grows linearly along u.
    double area = 0.0;
    constexpr int n = 50;
    for (int i = 0; i < n; ++i)
        area += 2.0 / n * 2.0 * triangle.at(-1.0 + (2.0 * i + 1.0) / n, 0.0).area_normal().norm();
    CHECK(area == Approx(0.5 * 0.3 * std::hypot(0.2, 0.1)));
}

}  // namespace
}  // namespace specula
