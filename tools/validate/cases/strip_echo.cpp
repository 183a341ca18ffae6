#include "tools/validate/cases/strip_echo.hpp"

#include <algorithm>
#include <cmath>

#include "sim/channel/channel.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/trace/trace.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Far below what any case allows; points are cheap.
constexpr double accuracy_db = 1e-3;
/// The strip is traced as some 1e6 points at most.
constexpr double most_wavelengths_away = 1000.0;
/// Where the strip begins to fade, over the distance of its farther rim.
constexpr double full = 1.5;

AntennaSet line_antennas(const StripScene& scene, LinePolarisation polarisation) {
    PlacedAntenna antenna;
    antenna.position_m = {0.0, 0.0, scene.height_m};
    if (polarisation == LinePolarisation::te)
        antenna.rotation = Eigen::AngleAxisd(0.5 * pi, Vector3::UnitZ()).toRotationMatrix();
    return {antenna, {antenna}};
}

/// No farther off than this is any point of the strip's cross-section.
double farthest_m(const StripScene& scene) {
    return scene.height_m + 0.5 * scene.width_m;
}

Target strip_of(const StripScene& scene, double reach) {
    Pose pose;
    pose.height_m = scene.height_m;
    pose.sample.about_y_rad = scene.tilt_rad;
    const Plate plate{.size_x_m = scene.width_m, .size_y_m = 2.0 * reach * farthest_m(scene)};
    return Target({plate_body(plate, sample_placement(pose), true, 0.0)});
}

/// Lets the strip fade out, so that its ends send nothing back: full up to `full`, nothing from
/// `reach` on, in shares of the farthest distance.
struct Fade {
    double full;
    double reach;
    double at(double distance) const {
        const double u = std::clamp((distance - full) / (reach - full), 0.0, 1.0);
        return 0.5 * (1.0 + std::cos(pi * u));
    }
};

/// Spherical waves thin out by one root of the way more than cylindrical ones.
void spread_in_two_dimensions(PairScatter& pair, const StripScene& scene, const Fade& fade) {
    for (std::size_t i = 0; i < pair.path_m.size(); ++i) {
        const double path_m = pair.path_m[i];
        const double factor =
            std::sqrt(path_m / (2.0 * scene.height_m)) * fade.at(0.5 * path_m / farthest_m(scene));
        for (std::vector<double>& weight : pair.weight) weight[i] *= factor;
    }
}

}  // namespace

std::string polarisation_name(LinePolarisation polarisation) {
    return polarisation == LinePolarisation::tm ? "TM" : "TE";
}

StripScene strip_scene_of(const Fields& inp, std::initializer_list<const char*> width_names) {
    const StripScene scene{
        .width_m = inp.number_of(width_names, Range::between(1e-3, 10.0)),
        .height_m = inp.number("H_m", Range::between(1e-3, 100.0)),
        .tilt_rad = inp.number_or("tilt_deg", 0.0, Range::between(-85.0, 85.0)) * pi / 180.0,
        .frequency_hz = frequency_of(inp)};
    const double wavelength_m = speed_of_light_m_s / scene.frequency_hz;
    if (scene.height_m + scene.width_m > most_wavelengths_away * wavelength_m)
        throw NotComputable(format("traces strips within {} wavelengths", most_wavelengths_away));
    if (0.5 * scene.width_m * std::sin(std::abs(scene.tilt_rad)) >= scene.height_m)
        throw NotComputable("does not tilt a strip up to its source");
    return scene;
}

StripEcho::StripEcho(const StripScene& scene, const Options& options)
    : scene_(scene),
      scatter_(trace(
          strip_of(scene, options.reach), line_antennas(scene, options.polarisation),
          {.highest_hz = scene.frequency_hz, .accuracy_db = accuracy_db, .edge_currents = true})) {
    const Fade fade{full, options.reach};
    for (RouteScatter& route : scatter_.routes)
        for (PairScatter& pair : route.rx) spread_in_two_dimensions(pair, scene, fade);
    for (EdgeScatter& edges : scatter_.edges)
        for (PairScatter& pair : edges.rx) spread_in_two_dimensions(pair, scene, fade);
}

Complex StripEcho::over_mirror(const Scatter& scatter, const Reflector& reflector) const {
    const double wavelength_m = speed_of_light_m_s / scene_.frequency_hz;
    const double path_m = 2.0 * scene_.height_m;
    const Complex mirror =
        -std::polar(wavelength_m / (4.0 * pi * path_m), -two_pi * path_m / wavelength_m);
    return direct_sum(scatter, 0, {&reflector, 1}, scene_.frequency_hz) / mirror;
}

Complex StripEcho::of(const Reflector& reflector) const {
    return over_mirror({.n_rx = 1, .routes = scatter_.routes}, reflector);
}

Complex StripEcho::with_edge_currents(const Reflector& reflector) const {
    return over_mirror(scatter_, reflector);
}

}  // namespace specula
