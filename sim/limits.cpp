#include "sim/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/channel/edge_channel.hpp"
#include "sim/channel/reflector.hpp"
#include "sim/clutter.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

namespace {

constexpr double fewest_wavelengths = 3.0;
constexpr double wide_dielectric_wavelengths = 20.0;
constexpr double weak_db = -15.0;

/// The smaller extent of a body's face; a mesh's second largest one.
double width_m(const Sample& matter) {
    if (!matter.mesh) return std::min(matter.face.size_x_m, matter.face.size_y_m);
    Vector3 low = matter.mesh->vertices_m.front(), high = low;
    for (const Vector3& vertex : matter.mesh->vertices_m) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    std::array<double, 3> extents{high.x() - low.x(), high.y() - low.y(), high.z() - low.z()};
    std::sort(extents.begin(), extents.end());
    return extents[1];
}

void add_limits(const std::string& name, const Sample& matter, const Stack& stack,
                const Solver& solver, std::vector<std::string>& limits) {
    const double wavelengths = width_m(matter) * stack.frequency_hz / speed_of_light_m_s;
    const bool metal = edge_coefficient(stack) != 0.0;
    if (wavelengths < fewest_wavelengths)
        limits.push_back(
            format("{} is {:.2g} wavelengths wide; below {:.0f} edges decide the "
                   "echo, not faces, and no error is known",
                   name, wavelengths, fewest_wavelengths));
    else if (!metal && wavelengths < wide_dielectric_wavelengths)
        limits.push_back(
            format("{}, no metal, is {:.3g} wavelengths wide; below {:.0f} the echo "
                   "may be off by up to 1.2 dB, at 4 by 5 dB and more",
                   name, wavelengths, wide_dielectric_wavelengths));
    if (solver.edge_currents && !metal)
        limits.push_back(format("edge_currents: {} is no metal; its edges are left out", name));
}

/// Mean power over receivers and frequencies.
double mean_power(const Channel& channel) {
    double sum = 0.0;
    for (const Complex& h : channel.h) sum += std::norm(h);
    return sum / static_cast<double>(channel.h.size());
}

double mean_reflected_power(const Reflector& reflector, const FrequencyComb& comb) {
    // A quarter of the samples: enough for sheets that swing over the band some ten times.
    const int step = std::max(1, comb.n / 32);
    double sum = 0.0;
    int n = 0;
    for (int i = 0; i < comb.n; i += step, ++n)
        sum += std::norm(stack_reflection(reflector(comb.at(i)), 1.0).te);
    return sum / n;
}

}  // namespace

std::vector<std::string> optics_limits(const Scene& scene, const Library& materials) {
    const double frequency_hz = scene.radar.chirp.centre_hz();
    const auto stack_of = [&](const Sample& matter) {
        return reflector_of(matter, materials)(frequency_hz);
    };
    std::vector<std::string> limits;
    add_limits("the sample", scene.sample, stack_of(scene.sample), scene.solver, limits);
    for (const SceneObject& object : scene.objects)
        add_limits(object.name, object.matter, stack_of(object.matter), scene.solver, limits);
    return limits;
}

std::vector<std::string> echo_limits(const Scene& scene, const Library& materials,
                                     const Channel& echo) {
    if (!scene.objects.empty()) return {};
    const double power = mean_power(echo);
    if (!(power > 0.0)) return {"the radar receives nothing from the sample"};
    const Chirp& chirp = scene.radar.chirp;
    const FrequencyComb comb = comb_of(chirp);
    const Reflector sample = reflector_of(scene.sample, materials, scene.pose.yaw_rad);
    const double mirror = mirror_transfer(scene.radar, scene.pose.height_m);
    const double level_db =
        10.0 * std::log10(power / (mirror * mirror * mean_reflected_power(sample, comb)));
    if (level_db > weak_db) return {};
    const bool with_edges =
        scene.solver.edge_currents && edge_coefficient(sample(chirp.centre_hz())) != 0.0;
    return {
        format("the echo is {:.1f} dB below that of an endless sheet; below {:.0f} dB edges "
               "count, and full-wave solutions differ by up to {}",
               -level_db, -weak_db,
               with_edges ? "0.5 dB even with edge_currents"
                          : "1.5 dB (metal: try edge_currents = true in [solver])")};
}

}  // namespace specula
