#include "scenes/sample.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::vector<SampleLayer> Sample::all_layers() const {
    if (!layers.empty()) return layers;
    return {{.material = material,
             .thickness_m = thickness_m,
             .roughness_m = roughness_m,
             .correlation_m = correlation_m}};
}

std::string Sample::title() const {
    std::string title;
    for (const SampleLayer& layer : all_layers())
        title += (title.empty() ? "" : " on ") + layer.material;
    return title;
}

Mesh Sample::triangles(const Placement& placement) const {
    return mesh ? placed(*mesh, placement) : triangulate(face, placement);
}

namespace {

constexpr double steepest_slope = 0.3;   ///< rms
constexpr double small_phase_rad = 0.3;  ///< below it, first order does, for any correlation

void warn_of(const SampleLayer& layer, const FrequencyBand& used,
             std::vector<std::string>& warnings) {
    if (layer.roughness_m == 0.0) return;
    const double slope = std::sqrt(2.0) * layer.roughness_m / layer.correlation_m;
    const double longest_m = speed_of_light_m_s / used.min_hz;
    const double phase_rad = 4.0 * pi * layer.roughness_m * used.max_hz / speed_of_light_m_s;
    if (slope > steepest_slope)
        warnings.push_back(format(
            "{}: heights of {:.4g} um rms over a correlation length of {:.4g} mm slope by {:.2g} "
            "rms; the diffuse echo is known to hold up to {}",
            layer.material, layer.roughness_m * 1e6, layer.correlation_m * 1e3, slope,
            steepest_slope));
    else if (layer.correlation_m < 0.5 * longest_m && phase_rad > small_phase_rad)
        warnings.push_back(format(
            "{}: a correlation length of {:.4g} mm is below half a wavelength ({:.4g} mm); the "
            "diffuse echo of heights of {:.4g} um rms may be off by some dB",
            layer.material, layer.correlation_m * 1e3, 0.5e3 * longest_m, layer.roughness_m * 1e6));
}

}  // namespace

std::vector<std::string> roughness_warnings(const Sample& sample, const FrequencyBand& used) {
    std::vector<std::string> warnings;
    for (const SampleLayer& layer : sample.all_layers()) warn_of(layer, used, warnings);
    return warnings;
}

std::vector<BandWarning> band_warnings(const Sample& sample, const Library& library,
                                       const FrequencyBand& used) {
    std::vector<std::string> names;
    for (const SampleLayer& layer : sample.all_layers()) names.push_back(layer.material);
    names.push_back(sample.backing);
    return band_warnings(library, names, used);
}

}  // namespace specula
