#include "sim/mirror_foot.hpp"

#include <cmath>

#include "sim/core/literals.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

using namespace literals;

const double usual_hz = 60.0_GHz;

TEST_CASE("untilted, the mirror's foot is the centre of the sample", "[foot]") {
    const MirrorFoot foot = mirror_foot({.height_m = 450.0_mm}, {}, usual_hz);
    CHECK(foot.x_m == 0.0);
    CHECK(foot.y_m == 0.0);
    CHECK(foot.range_m == Approx(450.0_mm));
    CHECK(foot.critical_size_m == 0.0);
    CHECK(foot.divergence_db == 0.0);
}

TEST_CASE("at the rim of the Fresnel zone the way is half a wave longer", "[foot]") {
    const MirrorFoot foot = mirror_foot({.height_m = 450.0_mm}, {}, usual_hz);
    const double way_m = 2.0 * std::hypot(foot.range_m, foot.fresnel_radius_m);
    const double wave_m = speed_of_light_m_s / usual_hz;
    // The zone's radius is that of the parabola: 3e-3 of the half wave at 45 cm.
    CHECK(way_m - 2.0 * foot.range_m == Approx(0.5 * wave_m).epsilon(3e-3));
}

TEST_CASE("a tilted sample moves the foot by height x sin, a tilted sensor does not", "[foot]") {
    Pose pose{.height_m = 450.0_mm};
    pose.sensor.about_y_rad = 10.0_deg;
    CHECK(mirror_foot(pose, {}, usual_hz).critical_size_m == 0.0);
    pose.sensor = {};
    for (const bool azimuth : {true, false}) {
        pose.sample = {};
        (azimuth ? pose.sample.about_y_rad : pose.sample.about_x_rad) = 10.0_deg;
        const MirrorFoot foot = mirror_foot(pose, {}, usual_hz);
        const double way_m = 450.0_mm * std::sin(10.0_deg);
        CHECK(std::abs(azimuth ? foot.x_m : foot.y_m) == Approx(way_m));
        CHECK((azimuth ? foot.y_m : foot.x_m) == Approx(0.0).margin(1e-15));
        CHECK(foot.critical_size_m == Approx(2.0 * way_m));
        CHECK(foot.range_m == Approx(450.0_mm * std::cos(10.0_deg)));
    }
}

TEST_CASE("the foot lies where the normal meets the radar, whatever the pivot", "[foot]") {
    Pose pose{.height_m = 450.0_mm,
              .sample = {3.0_deg, -8.0_deg},
              .pivot_m = {0.05, -0.1, -0.02},
              .offset_x_m = 0.03,
              .offset_y_m = -0.01,
              .yaw_rad = 20.0_deg};
    const MirrorFoot foot = mirror_foot(pose, {}, usual_hz);
    const Placement sample = sample_placement(pose);
    const Vector3 point_m = sample.point({foot.x_m, foot.y_m, 0.0});
    const Vector3 normal = sample.direction(Vector3::UnitZ());
    const Vector3 radar_m = point_m + foot.range_m * normal;
    CHECK((radar_m - Vector3(0.0, 0.0, pose.height_m)).norm() < 1e-12);  // rounding only
}

TEST_CASE("the margin is zero when the foot is on the rim", "[foot]") {
    Pose pose{.height_m = 450.0_mm};
    pose.sample.about_y_rad = 10.0_deg;
    const double edge_m = mirror_foot(pose, {}, usual_hz).critical_size_m;
    const Plate face{.size_x_m = edge_m, .size_y_m = 1.0};
    CHECK(mirror_foot(pose, face, usual_hz).margin(face) == Approx(0.0).margin(1e-12));
}

TEST_CASE("a dome of 1 mm on 30 cm costs a third of a decibel at 45 cm", "[foot]") {
    // Radius of the paraboloid: 0.15^2 / (2 * 0.001) = 11.25 m, so 1 / (1 + 0.45 / 11.25).
    const Plate dome{.bow_m = 1.0_mm};
    CHECK(mirror_foot({.height_m = 450.0_mm}, dome, usual_hz).divergence_db ==
          Approx(-20.0 * std::log10(1.04)));
}

}  // namespace
}  // namespace specula
