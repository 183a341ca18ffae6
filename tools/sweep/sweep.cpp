#include "tools/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "firmware/fw_extract.h"
#include "sim/channel/diffuse_power.hpp"
#include "sim/clutter.hpp"
#include "sim/limits.hpp"
#include "sim/parallel.hpp"
#include "sim/scene_target.hpp"
#include "sim/signal/dechirp.hpp"
#include "sim/speckle_echo.hpp"
#include "sim/trace/trace.hpp"
#include "tools/sweep/echo_profile.hpp"
#include "tools/sweep/sweep_geometry.hpp"

namespace specula {

namespace {

/// What one specimen returns in one geometry.
struct Measured {
    std::vector<double> power;    ///< (frequency) |h|^2; or its mean over the chirp alone
    std::vector<double> diffuse;  ///< as long: the part of it that is a mean over rough pieces
    EchoProfile profile{};        ///< of the coherent echo, without --freq
    bool is_weak = false;         ///< so far below a mirror that optics is in doubt; without --freq
};

/// The frequencies of the sums, and from which of them on they count.
struct SweptComb {
    FrequencyComb comb;
    int first_counted = 0;
};

SweptComb comb_of_plan(const SweepPlan& plan) {
    const auto& f_hz = plan.frequencies_hz;
    if (f_hz.empty())
        return {comb_of(plan.scene.radar.chirp), plan.scene.radar.chirp.settle_samples()};
    const int n = static_cast<int>(f_hz.size());
    return {{f_hz.front(), n > 1 ? (f_hz.back() - f_hz.front()) / (n - 1) : 0.0, n}, 0};
}

double decibels(double power) {
    return power > 0.0 ? std::max(darkest_db, 10.0 * std::log10(power)) : darkest_db;
}

double ratio_db(double power, double reference) {
    return reference > 0.0 ? decibels(power / reference) : darkest_db;
}

/// (frequency), or one mean over all of them.
std::vector<double> as_rows(std::vector<double> power, const SweepPlan& plan) {
    if (!plan.frequencies_hz.empty()) return power;
    double sum = 0.0;
    for (const double each : power) sum += each;
    return {sum / static_cast<double>(power.size())};
}

/// Mean over the RX at every frequency that counts.
std::vector<double> power_of(const Channel& channel, int first) {
    std::vector<double> power(static_cast<std::size_t>(channel.n_frequencies - first), 0.0);
    for (int rx = 0; rx < channel.n_rx; ++rx)
        for (std::size_t i = 0; i < power.size(); ++i)
            power[i] += std::norm(channel.of_rx(rx)[static_cast<int>(i) + first]) /
                        static_cast<double>(channel.n_rx);
    return power;
}

std::vector<double> mirror_power(const SweepPlan& plan, const SweptComb& swept, double height_m) {
    const Radar& radar = plan.scene.radar;
    const double centre = mirror_transfer(radar, height_m);
    std::vector<double> power;
    for (int i = swept.first_counted; i < swept.comb.n; ++i)
        power.push_back(std::pow(centre * radar.chirp.centre_hz() / swept.comb.at(i), 2.0));
    return as_rows(power, plan);
}

/// The same for a power at every RX and frequency.
std::vector<double> power_of(const std::vector<double>& values, const Channel& like, int first) {
    const auto n_f = static_cast<std::size_t>(like.n_frequencies);
    const auto n_rx = static_cast<std::size_t>(like.n_rx),
               skipped = static_cast<std::size_t>(first);
    std::vector<double> power(n_f - skipped, 0.0);
    if (values.empty()) return power;
    for (std::size_t rx = 0; rx < n_rx; ++rx)
        for (std::size_t i = 0; i < power.size(); ++i)
            power[i] += values[rx * n_f + skipped + i] / static_cast<double>(n_rx);
    return power;
}

/// A scene with its bodies in place, traced.
struct Traced {
    Target target;
    AntennaSet antennas;
    Scatter scatter;

    Traced(const Scene& scene, std::span<const Reflector> reflectors, double highest_hz)
        : target(target_of(scene, reflectors)),
          antennas(antennas_of(scene.radar, radar_placement(scene.pose))),
          scatter(trace(target, antennas,
                        {.highest_hz = highest_hz,
                         .accuracy_db = scene.solver.accuracy_db,
                         .max_bounces = scene.solver.max_bounces,
                         .edge_currents = scene.solver.edge_currents})) {}
};

/// What the rough faces scatter, mean over all pieces, (rx, frequency); empty where it is nothing.
std::vector<double> diffuse_power(const Scene& scene, const Traced& traced,
                                  std::span<const Reflector> reflectors,
                                  const FrequencyComb& comb) {
    std::vector<double> sum;
    if (scene.solver.roughness == Solver::Roughness::coherent) return sum;
    for (std::size_t body = 0; body < reflectors.size(); ++body)
        for (const RoughLayer& layer : rough_layers({static_cast<int>(body), reflectors[body]},
                                                    comb, scene.solver.accuracy_db)) {
            const auto power = mean_diffuse_power(
                diffuse_cells(traced.target, traced.antennas, layer), reflectors, comb);
            sum.resize(power.size(), 0.0);
            for (std::size_t i = 0; i < power.size(); ++i) sum[i] += power[i];
        }
    return sum;
}

/// Specimens that look alike to rays share a trace: all of them where nothing lies behind the
/// sample, else those through which nothing comes, and sheets of one thickness.
double look_of(const Scene& scene, const Reflector& reflector) {
    if (scene.objects.empty() || is_opaque(scene.sample, reflector, scene.radar.chirp.centre_hz()))
        return 0.0;
    return scene.sample.thickness_m;
}

std::vector<Measured> measure(const SweepPlan& plan, const Library& materials,
                              const SweptComb& swept, const SweepGeometry& geometry) {
    Scene scene = plan.scene;
    scene.pose = geometry.pose(plan.scene.pose);
    std::map<double, Traced> traced;  // (look)
    std::vector<Measured> all;
    for (const Specimen& specimen : plan.specimens) {
        scene.sample = specimen.sample;
        if (!scene.sample.mesh) scene.sample.face = geometry.face(plan.scene.sample.face);
        const auto reflectors = reflectors_of(scene, materials);
        const double look = look_of(scene, reflectors[0]);
        const auto found = traced.find(look);
        const Traced& stage =
            found != traced.end()
                ? found->second
                : traced.try_emplace(look, scene, reflectors, swept.comb.last_hz()).first->second;
        const Channel channel = channel_of(stage.scatter, reflectors, swept.comb);
        const auto diffuse = power_of(diffuse_power(scene, stage, reflectors, swept.comb), channel,
                                      swept.first_counted);
        std::vector<double> power = power_of(channel, swept.first_counted);
        for (std::size_t i = 0; i < power.size(); ++i) power[i] += diffuse[i];
        Measured measured{as_rows(std::move(power), plan), as_rows(diffuse, plan)};
        if (plan.frequencies_hz.empty()) {
            measured.profile = echo_profile(channel, scene.radar);
            measured.is_weak = !echo_limits(scene, materials, channel).empty();
        }
        all.push_back(std::move(measured));
    }
    return all;
}

std::vector<double> descriptor_bins(const EchoProfile& profile) {
    const auto n = profile.bin_lsb.size();
    const auto first = std::min<std::size_t>(FW_DEFAULT_FIRST_BIN, n);
    const auto last = std::min<std::size_t>(first + FW_DEFAULT_N_BINS, n);
    return {profile.bin_lsb.begin() + static_cast<std::ptrdiff_t>(first),
            profile.bin_lsb.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

std::size_t n_traces(const SweepPlan& plan) {
    return numbered_geometries(plan).size();
}

const SweepRow& Sweep::row(const SweepIndex& at) const {
    std::size_t i = at.specimen;
    i = i * plan.sizes_m.size() + at.size;
    i = i * plan.tiltings.size() + at.tilting;
    i = i * plan.heights_m.size() + at.height;
    i = i * plan.tilts_rad.size() + at.tilt;
    i = i * plan.n_frequencies() + at.frequency;
    return rows.at(i);
}

Sweep run_sweep(const SweepPlan& plan, const Library& materials, int threads,
                std::atomic<std::size_t>& done) {
    const auto numbers = numbered_geometries(plan);
    const SweptComb swept = comb_of_plan(plan);
    std::vector<const SweepGeometry*> geometries(numbers.size());
    for (const auto& [geometry, number] : numbers) geometries[number] = &geometry;
    std::vector<std::vector<Measured>> measured(numbers.size());  // (geometry, specimen)
    const auto work = [&](std::size_t i) {
        measured[i] = measure(plan, materials, swept, *geometries[i]);
    };
    for_each_index(numbers.size(), threads, work, &done);

    Sweep sweep{plan, {}};
    sweep.rows.reserve(plan.n_rows());
    for (std::size_t specimen = 0; specimen < plan.specimens.size(); ++specimen)
        for_each_geometry(plan, [&](SweepIndex at) {
            at.specimen = specimen;
            const SweepGeometry geometry = geometry_at(plan, at);
            const auto of = [&](const SweepGeometry& other) -> const Measured& {
                return measured[numbers.at(other)][specimen];
            };
            const Measured& own = of(geometry);
            const auto mirror = mirror_power(plan, swept, geometry.height_m);
            for (at.frequency = 0; at.frequency < own.power.size(); ++at.frequency) {
                const std::size_t f = at.frequency;
                sweep.rows.push_back(
                    {.at = at,
                     .level_db = decibels(own.power[f]),
                     .diffuse_db = decibels(own.diffuse[f]),
                     .over_mirror_db = ratio_db(own.power[f], mirror[f]),
                     .over_untilted_db = ratio_db(own.power[f], of(untilted(geometry)).power[f]),
                     .over_nominal_db =
                         ratio_db(own.power[f], of(nominal(geometry, plan)).power[f]),
                     .peak_bin = own.profile.peak_bin,
                     .centroid_bin = own.profile.centroid_bin,
                     .is_weak = own.is_weak,
                     .bin_lsb = descriptor_bins(own.profile)});
            }
        });
    return sweep;
}

}  // namespace specula
