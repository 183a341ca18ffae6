#include "materials/transmission.hpp"
#include "sim/channel/channel.hpp"
#include "sim/core/constants.hpp"
#include "sim/trace/trace.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

/// An isotropic antenna that looks along a direction.
PlacedAntenna antenna_at(const Vector3& position, const Vector3& along) {
    Rotation frame;
    frame.col(2) = -along.normalized();
    frame.col(1) = along.unitOrthogonal();
    frame.col(0) = frame.col(1).cross(frame.col(2));
    return {position, frame, IsotropicPattern{}};
}

Mesh trihedral(double leg_m) {
    return {{{0, 0, 0}, {leg_m, 0, 0}, {0, leg_m, 0}, {0, 0, leg_m}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
}

/// Radar cross-section of what a far radar sees, from |h|^2 = lambda^2 sigma / ((4 pi)^3 R^4).
double cross_section_m2(const Scatter& scatter, double range_m) {
    const Reflector mirror = perfect_conductor();
    const double wavelength_m = speed_of_light_m_s / test_frequency_hz;
    return std::norm(direct_sum(scatter, 0, {&mirror, 1}, test_frequency_hz)) *
           std::pow(4.0 * pi, 3) * std::pow(range_m, 4) / (wavelength_m * wavelength_m);
}

TEST_CASE("a triangular trihedral returns what its aperture says", "[trace][reference]") {
    constexpr double far_m = 1000.0;
    for (const auto& point : reference_case("R06_trihedral")["points"]) {
        const double theta = point["inp"]["theta_deg"].get<double>() * pi / 180.0;
        const double phi = point["inp"]["phi_deg"].get<double>() * pi / 180.0;
        const Vector3 towards(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta));
        const Target target({mesh_body(trihedral(point["inp"]["leg_a_m"]), true, 0.0)});
        const PlacedAntenna radar = antenna_at(far_m * towards, -towards);
        Scatter scatter = trace(target, {radar, {radar}}, {.highest_hz = test_frequency_hz});
        const double expected_m2 = point["expect"]["sigma_m2"];
        // Single and double bounces add to the reference's three: its tolerance is 1 dB.
        CHECK(10.0 * std::log10(cross_section_m2(scatter, far_m) / expected_m2) ==
              Approx(0.0).margin(0.5));
        std::erase_if(scatter.routes,
                      [](const RouteScatter& r) { return r.route.before.size() != 2; });
        CHECK(10.0 * std::log10(cross_section_m2(scatter, far_m) / expected_m2) ==
              Approx(0.0).margin(0.05));
    }
}

TEST_CASE("two sheets of metal at right angles mirror the radar three times",
          "[trace][reference]") {
    const auto point = reference_case("N07_dihedral_image")["points"][0];
    constexpr double wide_m = 2.0, high_m = 2.0;
    const auto wall = [&](const Vector3& along) {
        return mesh_body({{{0, 0, -high_m / 2},
                           wide_m * along - Vector3(0, 0, high_m / 2),
                           wide_m * along + Vector3(0, 0, high_m / 2),
                           {0, 0, high_m / 2}},
                          {{0, 1, 2}, {0, 2, 3}}},
                         true, 0.0);
    };
    const Target target({wall(Vector3::UnitY()), wall(Vector3::UnitX())});
    PlacedAntenna radar = antenna_at({0.3, 0.4, 0.0}, {-1.0, -1.0, 0.0});
    radar.rotation.col(1) = Vector3::UnitZ();  // polarised along the edge
    radar.rotation.col(0) = radar.rotation.col(1).cross(radar.rotation.col(2));
    const Scatter scatter =
        trace(target, {radar, {radar}}, {.highest_hz = test_frequency_hz, .max_bounces = 2});
    const Reflector mirrors[] = {perfect_conductor(), perfect_conductor()};
    const Complex total = direct_sum(scatter, 0, mirrors, test_frequency_hz);
    const Deviation off = deviation(total, complex_of(point["expect"]["total"]["h"]));
    CHECK(off.db < 0.15);  // the reference's tolerance: the rims of finite walls ripple
    CHECK(off.phase_deg < 3.0);
}

TEST_CASE("a sheet over metal echoes once for every round in the gap", "[trace]") {
    constexpr double gap_m = 0.02, thickness_m = 0.005, height_m = 0.45;
    constexpr int rounds = 2;  // sheet, table, sheet from below, table
    PlateScene scene;
    scene.plate = {.size_x_m = 0.4, .size_y_m = 0.4};
    scene.pattern = PatchPattern{};  // its narrow beam keeps the rims dark
    Placement below = scene.plate_placement();
    below.shift_m.z() -= gap_m + thickness_m;
    const Target target({plate_body(scene.plate, scene.plate_placement(), false, thickness_m),
                         plate_body({.size_x_m = 0.5, .size_y_m = 0.5}, below, true, 0.0)});
    const Reflector bodies[] = {slab({2.6, -0.026}, thickness_m), perfect_conductor()};
    const Scatter scatter = trace(target, scene.antennas(),
                                  {.highest_hz = test_frequency_hz, .max_bounces = 2 * rounds - 1});

    // Wide faces are images: each round in the gap is a mirror so much further away.
    const Stack sheet = bodies[0](test_frequency_hz);
    const Complex r = stack_reflection(sheet, 1.0).te, t = stack_transmission(sheet, 1.0).te;
    const double k = two_pi * test_frequency_hz / speed_of_light_m_s;
    Complex images = r / height_m;
    for (int m = 1; m <= rounds; ++m)
        images += -t * t * std::pow(-r, m - 1) * std::polar(1.0, -2.0 * k * gap_m * m) /
                  (height_m + m * (gap_m + thickness_m));
    const double gain = gain_towards(scene.pattern, {0.0, 0.0, -1.0});
    const Complex expected = images * std::polar(gain / (4.0 * k), -2.0 * k * height_m);
    // Three echoes of finite faces, each within the 0.3 dB and 4 degrees that case N06 gives one.
    const Deviation off = deviation(direct_sum(scatter, 0, bodies, test_frequency_hz), expected);
    CHECK(off.db < 0.3 * std::sqrt(3.0));
    CHECK(off.phase_deg < 4.0 * std::sqrt(3.0));
}

}  // namespace
}  // namespace specula
