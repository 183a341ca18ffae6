#include "sim/trace/geometry.hpp"

#include <limits>

#include "sim/core/error.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

/// A square in the plane z = height, centred above the origin.
Mesh square(double side_m, double height_m) {
    return triangulate({.size_x_m = side_m, .size_y_m = side_m}, {.shift_m = {0, 0, height_m}});
}

bool is_clear(const Geometry& geometry, const Vector3& from, const Vector3& to) {
    char clear = 1;
    geometry.shadow(from, std::span(&to, 1), std::span(&clear, 1));
    return clear == 1;
}

TEST_CASE("a screen shadows exactly what lies behind it", "[trace]") {
    const Geometry geometry({square(0.2, 0.3)});  // half way down from a radar at 0.6 m
    const Vector3 radar(0.0, 0.0, 0.6);
    for (int i = 0; i <= 40; ++i) {
        const double x_m = 0.02 * i - 0.4;
        if (std::abs(std::abs(x_m) - 0.2) < 1e-3) continue;  // the shadow's rim, twice the screen's
        INFO("x = " << x_m);
        CHECK(is_clear(geometry, radar, {x_m, 0.05, 0.0}) == (std::abs(x_m) > 0.2));
    }
}

TEST_CASE("a shadow falls along the ray, whichever end asks", "[trace]") {
    const Geometry geometry({square(0.2, 0.3)});
    const Vector3 left(-0.5, 0.0, 0.6), below(0.5, 0.0, 0.0), beside(0.2, 0.0, 0.0);
    CHECK_FALSE(is_clear(geometry, left, below));
    CHECK_FALSE(is_clear(geometry, below, left));
    CHECK(is_clear(geometry, left, beside));  // crosses the screen's plane at x = -0.15
    CHECK(is_clear(geometry, beside, left));
}

TEST_CASE("neither what is behind the point nor what is behind the antenna shadows it", "[trace]") {
    const Geometry geometry({square(1.0, -0.1), square(1.0, 0.7)});
    CHECK(is_clear(geometry, {0.0, 0.0, 0.6}, {0.1, 0.1, 0.0}));
}

TEST_CASE("the last tenth of a millimetre is not looked at", "[trace]") {
    const Vector3 radar(0.0, 0.0, 1.0), point(0.0, 0.0, 0.0);
    CHECK(is_clear(Geometry({square(0.1, 0.00009)}), radar, point));
    CHECK_FALSE(is_clear(Geometry({square(0.1, 0.00011)}), radar, point));
}

TEST_CASE("of many points only the hidden ones lose their mark", "[trace]") {
    const Geometry geometry({square(0.2, 0.3)});
    std::vector<Vector3> points;
    std::vector<char> clear, expected;
    for (int i = 0; i < 53; ++i) {  // more than three packets of 16, the last one not full
        points.push_back({i % 3 == 0 ? 0.0 : 0.5, 0.001 * i, 0.0});
        clear.push_back(i % 2 == 0);
        expected.push_back(i % 2 == 0 && i % 3 != 0);
    }
    geometry.shadow({0.0, 0.0, 0.6}, points, clear);
    CHECK(clear == expected);
}

TEST_CASE("in an empty scene everything is clear", "[trace]") {
    CHECK(is_clear(Geometry({}), {0.0, 0.0, 0.6}, {0.0, 0.0, 0.0}));
    CHECK(is_clear(Geometry({Mesh{}}), {0.0, 0.0, 0.6}, {0.0, 0.0, 0.0}));
}

TEST_CASE("a point that is not finite keeps its mark and spoils no other", "[trace]") {
    const Geometry geometry({square(0.2, 0.3)});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vector3> points{{nan, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}};
    std::vector<char> clear{1, 1, 1};
    geometry.shadow({0.0, 0.0, 0.6}, points, clear);
    CHECK(clear == std::vector<char>{1, 0, 1});
}

TEST_CASE("a mesh that is no surface is refused", "[trace]") {
    Mesh mesh = square(0.2, 0.0);
    const auto refuse = [&] { return Geometry({mesh}); };
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e300}) {
        mesh = square(0.2, 0.0);
        mesh.vertices_m[2].y() = bad;
        CHECK_THROWS_AS(refuse(), InputError);
    }
    mesh = square(0.2, 0.0);
    mesh.triangles[1][2] = 4;
    CHECK_THROWS_AS(refuse(), InputError);
}

TEST_CASE("a geometry that moved still casts its shadow", "[trace]") {
    Geometry first({square(0.2, 0.3)});
    Geometry second(std::move(first));
    CHECK_FALSE(is_clear(second, {0.0, 0.0, 0.6}, {0.0, 0.0, 0.0}));
    Geometry third({});
    third = std::move(second);
    CHECK_FALSE(is_clear(third, {0.0, 0.0, 0.6}, {0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace specula
