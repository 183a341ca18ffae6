#include "sim/core/constants.hpp"
#include "sim/link_budget.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/spectrum.hpp"

// The corner reflector of scenes/examples, from its STL file to ADC codes, against the radar
// equation.

namespace specula {
namespace {

constexpr double leg_m = 0.06;

Scene trihedral_scene() {
    static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    return read_scene(SPECULA_SOURCE_DIR "/scenes/examples/trihedral.toml", catalogue);
}

/// The strongest tone near the scene's height, as a level at the RX: high-pass and gain undone.
double received_dbm(const Scene& scene) {
    static const Library library(SPECULA_SOURCE_DIR "/materials/library");
    Stream noise({.seed = 1, .purpose = "thermal noise"});
    const AdcFrame frame = simulate(scene, library, noise);
    const std::vector<double> codes(frame.codes.begin(), frame.codes.begin() + frame.n_samples);
    const double at = scene.radar.chirp.bin_of(scene.pose.height_m);
    double peak_lsb = 0.0;
    for (double bin = at - 3.0; bin < at + 3.0; bin += 0.05)
        peak_lsb = std::max(peak_lsb, amplitude_at(codes, "blackman", bin));
    const LinkBudget mirror = mirror_budget(scene.radar, scene.pose.height_m);
    return mirror.received_dbm + decibel(peak_lsb / mirror.amplitude_lsb);
}

/// @in sigma_m2 a far target of this cross-section in the middle of the beam
double radar_equation_dbm(const Scene& scene, double sigma_m2) {
    const double wavelength_m = speed_of_light_m_s / scene.radar.chirp.centre_hz();
    const double gain = gain_towards(scene.radar.pattern, {0.0, 0.0, -1.0});
    const double range_m = scene.pose.height_m;
    return scene.radar.tx_power_dbm +
           10.0 * std::log10(gain * gain * wavelength_m * wavelength_m * sigma_m2 /
                             (std::pow(4.0 * pi, 3) * std::pow(range_m, 4)));
}

/// Robertson 1947 with the three direction cosines, least first: the opening seen along them.
double trihedral_m2(const Vector3& towards, double wavelength_m) {
    Vector3 c = towards.normalized();
    std::sort(c.begin(), c.end());
    const double sum = c.sum();
    const double open = c[0] + c[1] <= c[2] ? 4.0 * c[0] * c[1] / sum : sum - 2.0 / sum;
    return 4.0 * pi * std::pow(leg_m, 4) / (wavelength_m * wavelength_m) * open * open;
}

TEST_CASE("the trihedral of the examples reads what 4 pi a^4 / (3 lambda^2) says", "[sim][mesh]") {
    const Scene scene = trihedral_scene();
    const double wavelength_m = speed_of_light_m_s / scene.radar.chirp.centre_hz();
    const double sigma_m2 = 4.0 * pi * std::pow(leg_m, 4) / (3.0 * wavelength_m * wavelength_m);
    CHECK(trihedral_m2({1, 1, 1}, wavelength_m) == Approx(sigma_m2));
    // 1 dB is the promise. Single and double bounces, and at 2 m the aperture's near field.
    CHECK(received_dbm(scene) == Approx(radar_equation_dbm(scene, sigma_m2)).margin(1.0));
}

TEST_CASE("a trihedral turned out of its axis reads its smaller opening", "[sim][mesh]") {
    for (const double turned_deg : {10.0, -15.0}) {
        Scene scene = trihedral_scene();
        scene.pose.sample.about_y_rad = turned_deg * pi / 180.0;
        const Rotation to_scene =
            (Eigen::AngleAxisd(scene.pose.sample.about_y_rad, Vector3::UnitY()) *
             Eigen::AngleAxisd(-35.26439 * pi / 180.0, Vector3::UnitY()) *
             Eigen::AngleAxisd(0.25 * pi, Vector3::UnitX()))
                .toRotationMatrix();
        const double wavelength_m = speed_of_light_m_s / scene.radar.chirp.centre_hz();
        const double sigma_m2 = trihedral_m2(to_scene.transpose().col(2), wavelength_m);
        INFO("turned by " << turned_deg << " deg");
        CHECK(received_dbm(scene) == Approx(radar_equation_dbm(scene, sigma_m2)).margin(1.0));
    }
}

}  // namespace
}  // namespace specula
