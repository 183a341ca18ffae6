#include "scenes/plate.hpp"

#include <cmath>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a positive bow lowers the edge midpoints by the bow and the corners by two", "[plate]") {
    const Plate dome{.size_x_m = 0.3, .size_y_m = 0.2, .bow_m = 2e-3};
    CHECK(dome.height_m(0.0, 0.0) == 0.0);
    CHECK(dome.height_m(0.15, 0.0) == Approx(-2e-3));
    CHECK(dome.height_m(0.0, -0.1) == Approx(-2e-3));
    CHECK(dome.height_m(-0.15, 0.1) == Approx(-4e-3));
}

TEST_CASE("the area normal is that of the surface, by its numerical gradient", "[plate]") {
    for (const Plate& plate : {Plate{0.3, 0.2, 2e-3}, Plate{0.05, 0.4, -1e-2}, Plate{0.3, 0.3, 0}})
        for (const double x_share : {-0.5, -0.2, 0.0, 0.4})
            for (const double y_share : {-0.4, 0.0, 0.5}) {
                const double x_m = x_share * plate.size_x_m, y_m = y_share * plate.size_y_m;
                // A parabola's central difference is exact: rounding of 1e-2 / step remains.
                const double step_m = 1e-3, tolerance = 1e-14;
                const double slope_x =
                    (plate.height_m(x_m + step_m, y_m) - plate.height_m(x_m - step_m, y_m)) /
                    (2.0 * step_m);
                const double slope_y =
                    (plate.height_m(x_m, y_m + step_m) - plate.height_m(x_m, y_m - step_m)) /
                    (2.0 * step_m);
                const Vector3 normal = plate.area_normal(x_m, y_m);
                CHECK(std::abs(normal.x() + slope_x) < tolerance);
                CHECK(std::abs(normal.y() + slope_y) < tolerance);
                CHECK(normal.z() == 1.0);
            }
}

}  // namespace
}  // namespace specula
