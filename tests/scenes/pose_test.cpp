#include "scenes/pose.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/literals.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

using namespace literals;

constexpr double pose_rounding = 1e-15;

double distance(const Vector3& a, const Vector3& b) {
    return (a - b).norm();
}

TEST_CASE("an untilted radar stands above the sample's centre and looks down", "[pose]") {
    const Placement radar = radar_placement({.height_m = 0.45});
    CHECK(radar.point(Vector3::Zero()) == Vector3(0.0, 0.0, 0.45));
    CHECK(radar.direction({0.0, 0.0, -1.0}) == Vector3(0.0, 0.0, -1.0));
    const Placement sample = sample_placement({.height_m = 0.45});
    CHECK(sample.point({0.1, 0.2, 0.0}) == Vector3(0.1, 0.2, 0.0));
    CHECK(sample.direction({0.0, 0.0, 1.0}) == Vector3(0.0, 0.0, 1.0));
}

TEST_CASE("a tilt of the sensor leaves its phase centre where it is", "[pose]") {
    const Pose pose{.height_m = 0.45, .sensor = {.about_x_rad = 0.3, .about_y_rad = -0.7}};
    CHECK(radar_placement(pose).point(Vector3::Zero()) == Vector3(0.0, 0.0, 0.45));
    // An antenna 6 mm beside it moves on a circle.
    CHECK(distance(radar_placement(pose).point({6e-3, 0.0, 0.0}), {0.0, 0.0, 0.45}) ==
          Approx(6e-3));
}

TEST_CASE("tilts turn by the right-hand rule: about y in azimuth, about x in elevation", "[pose]") {
    const double s = std::sin(10.0_deg), c = std::cos(10.0_deg);
    const Placement azimuth = radar_placement({.sensor = {.about_y_rad = 10.0_deg}});
    CHECK(distance(azimuth.direction({0.0, 0.0, -1.0}), {-s, 0.0, -c}) < pose_rounding);
    CHECK(distance(azimuth.direction({0.0, 1.0, 0.0}), {0.0, 1.0, 0.0}) < pose_rounding);
    const Placement elevation = radar_placement({.sensor = {.about_x_rad = 10.0_deg}});
    CHECK(distance(elevation.direction({0.0, 0.0, -1.0}), {0.0, s, -c}) < pose_rounding);
    CHECK(distance(elevation.direction({1.0, 0.0, 0.0}), {1.0, 0.0, 0.0}) < pose_rounding);

    const Placement sample = sample_placement({.sample = {.about_y_rad = 10.0_deg}});
    CHECK(distance(sample.direction({0.0, 0.0, 1.0}), {s, 0.0, c}) < pose_rounding);
    CHECK(distance(sample.point({0.15, 0.0, 0.0}), {0.15 * c, 0.0, -0.15 * s}) < pose_rounding);
}

TEST_CASE("of two tilts the one about x comes first", "[pose]") {
    const double a = 0.3, b = -0.7;
    Rotation about_x, about_y;
    about_x << 1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a);
    about_y << std::cos(b), 0, std::sin(b), 0, 1, 0, -std::sin(b), 0, std::cos(b);
    const Pose::Tilt tilt{.about_x_rad = a, .about_y_rad = b};
    CHECK((radar_placement({.sensor = tilt}).rotation - about_y * about_x).norm() < pose_rounding);
    CHECK((sample_placement({.sample = tilt}).rotation - about_y * about_x).norm() < pose_rounding);
}

TEST_CASE("a tilted sample turns about its pivot", "[pose]") {
    const Vector3 pivot_m(0.05, -0.1, 0.02);
    const Pose pose{.sample = {.about_x_rad = 0.2, .about_y_rad = 0.4},
                    .pivot_m = pivot_m,
                    .offset_x_m = 0.03,
                    .offset_y_m = 0.01};
    const Placement placement = sample_placement(pose);
    // The pivot, seen from the offset sample before it was tilted.
    CHECK(distance(placement.point(pivot_m - Vector3(0.03, 0.01, 0.0)), pivot_m) < pose_rounding);
    Pose untilted = pose;
    untilted.sample = {};
    CHECK(distance(sample_placement(untilted).point(Vector3::Zero()), {0.03, 0.01, 0.0}) <
          pose_rounding);
}

TEST_CASE("yaw turns the sample about its own centre and in its own plane", "[pose]") {
    const Pose pose{.sample = {.about_y_rad = 0.3}, .offset_x_m = 0.05, .yaw_rad = 90.0_deg};
    Pose straight = pose;
    straight.yaw_rad = 0.0;
    const Placement turned = sample_placement(pose), before = sample_placement(straight);
    CHECK(turned.point(Vector3::Zero()) == before.point(Vector3::Zero()));
    const Vector3 normal(0.0, 0.0, 1.0);
    CHECK(distance(turned.direction(normal), before.direction(normal)) < pose_rounding);
    CHECK(distance(turned.direction({1.0, 0.0, 0.0}), before.direction({0.0, 1.0, 0.0})) <
          pose_rounding);
}

TEST_CASE("placements are rigid: no stretching, no mirror", "[pose]") {
    const Pose pose{.sensor = {0.5, -1.2},
                    .sample = {-0.4, 0.9},
                    .pivot_m = {0.1, 0.2, 0.3},
                    .offset_x_m = -0.2,
                    .yaw_rad = 2.0};
    for (const Placement& placement : {radar_placement(pose), sample_placement(pose)}) {
        CHECK((placement.rotation * placement.rotation.transpose() - Rotation::Identity()).norm() <
              pose_rounding);
        CHECK(placement.rotation.determinant() == Approx(1.0).epsilon(pose_rounding));
    }
}

}  // namespace
}  // namespace specula
