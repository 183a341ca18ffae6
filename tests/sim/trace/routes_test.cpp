#include "sim/channel/channel.hpp"
#include "sim/core/constants.hpp"
#include "sim/trace/trace.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

constexpr double frequency_hz = 60e9;

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
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    return std::norm(direct_sum(scatter, 0, {&mirror, 1}, frequency_hz)) * std::pow(4.0 * pi, 3) *
           std::pow(range_m, 4) / (wavelength_m * wavelength_m);
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
        Scatter scatter = trace(target, {radar, {radar}}, {.highest_hz = frequency_hz});
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
        trace(target, {radar, {radar}}, {.highest_hz = frequency_hz, .max_bounces = 2});
    const Reflector mirrors[] = {perfect_conductor(), perfect_conductor()};
    const Complex total = direct_sum(scatter, 0, mirrors, frequency_hz);
    const Deviation off = deviation(total, complex_of(point["expect"]["total"]["h"]));
    CHECK(off.db < 0.15);  // the reference's tolerance: the rims of finite walls ripple
    CHECK(off.phase_deg < 3.0);
}

TEST_CASE("a sheet over metal echoes as the stack of both", "[trace]") {
    constexpr double gap_m = 0.02, thickness_m = 0.005;
    const Complex permittivity(2.6, -0.026);
    PlateScene scene;
    scene.plate = {.size_x_m = 0.4, .size_y_m = 0.4};
    Placement below = scene.plate_placement();
    below.shift_m.z() -= gap_m + thickness_m;
    const Target target({plate_body(scene.plate, scene.plate_placement(), false, thickness_m),
                         plate_body({.size_x_m = 0.6, .size_y_m = 0.6}, below, true, 0.0)});
    const Reflector bodies[] = {slab(permittivity, thickness_m), perfect_conductor()};
    const Reflector stack = [=](double f_hz) {
        return Stack{{Layer{.medium = {permittivity}, .thickness_m = thickness_m},
                      Layer{.medium = {}, .thickness_m = gap_m}},
                     PerfectConductor{},
                     f_hz};
    };
    const Scatter scatter =
        trace(target, scene.antennas(), {.highest_hz = frequency_hz, .max_bounces = 7});
    const Complex found = direct_sum(scatter, 0, bodies, frequency_hz);
    const Complex expected = scene.transfer(stack, frequency_hz);
    // The rims of two plates at two heights ripple against each other: by 0.7 dB each for 40 cm.
    CHECK(deviation(found, expected).db < 1.5);

    const Scatter sheet_only =
        trace(Target({plate_body(scene.plate, scene.plate_placement(), false, thickness_m)}),
              scene.antennas(), {.highest_hz = frequency_hz});
    CHECK(deviation(direct_sum(sheet_only, 0, bodies, frequency_hz), expected).db > 6.0);
}

}  // namespace
}  // namespace specula
