#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/simulate.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

constexpr double degree_rad = pi / 180.0;
constexpr double converged_db = 1e-5;  ///< accuracy of the integral that ours is held against

Scatter scatter_of(const OpenScene& open, double accuracy_db) {
    TraceSettings settings = open.settings;
    settings.accuracy_db = accuracy_db;
    settings.lowest_hz = 0.0;  // every point by itself
    return trace(open.target, open.antennas, settings);
}

/// Largest distance of a channel from the plain sum over its largest value, at some frequencies.
double off_the_plain_sum(const Channel& channel, const Scatter& scatter, const OpenScene& open) {
    constexpr int looks = 5;
    double off = 0.0, largest = 0.0;
    for (const Complex& h : channel.h) largest = std::max(largest, std::abs(h));
    for (int rx = 0; rx < channel.n_rx; ++rx)
        for (int look = 0; look < looks; ++look) {
            const int i = (open.comb.n - 1) * look / (looks - 1);
            const Complex plain = direct_sum(scatter, rx, open.reflectors, open.comb.at(i));
            off = std::max(off, std::abs(channel.of_rx(rx)[i] - plain));
        }
    return largest > 0.0 ? off / largest : 0.0;
}

/// Path-samples: one point of the surface, at one RX and one sample of the chirp.
double path_samples(const Scatter& scatter, const OpenScene& open) {
    return static_cast<double>(scatter.n_points()) * open.comb.n;
}

void add_sums(const BenchPlan& plan, const OpenScene& open, BenchReport& report) {
    const Scatter scatter = scatter_of(open, converged_db);
    const double at_one_hz = static_cast<double>(scatter.routes.front().rx.front().path_m.size());
    report.add({.part = "channel",
                .name = "plain double sum",
                .unit = "path-samples",
                .per_second = at_one_hz / seconds_per_call(plan.budget_s, [&] {
                                  direct_sum(scatter, 0, open.reflectors, open.comb.first_hz);
                              })});
    const Channel channel = channel_of(scatter, open.reflectors, open.comb);
    report.add(
        {.part = "channel",
         .name = "moments",
         .unit = "path-samples",
         .per_second = path_samples(scatter, open) /
                       seconds_per_call(plan.budget_s,
                                        [&] { channel_of(scatter, open.reflectors, open.comb); }),
         .limit = "plain double sum",
         .error = off_the_plain_sum(channel, scatter, open),
         .oracle = "plain double sum"});
}

/// Geometry to channel, smooth samples and rough ones.
void add_echoes(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    for (const char* material : {"plexiglass", "limestone"})
        for (const int tilt_deg : {0, 5, 10, 15}) {
            const Scene tilted = scene.plate(material, tilt_deg * degree_rad);
            const OpenScene open(tilted, scene.catalogue.materials);
            const Scatter converged = scatter_of(open, converged_db);
            const Channel coherent = channel_of(trace(open.target, open.antennas, open.settings),
                                                open.reflectors, open.comb);
            report.add(
                {.part = "channel",
                 .name = format("new geometries, {}, tilt {} deg", material, tilt_deg),
                 .unit = "geometries",
                 .per_second = 1.0 / seconds_per_call(
                                         plan.budget_s,
                                         [&] { echo_channel(tilted, scene.catalogue.materials); }),
                 .error = off_the_plain_sum(coherent, converged, open),
                 .oracle = "converged integral, summed plainly"});
        }
}

}  // namespace

void bench_channel(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    const OpenScene open(scene.plate("plexiglass", 5.0 * degree_rad), scene.catalogue.materials);
    add_sums(plan, open, report);
    add_echoes(plan, scene, report);
}

}  // namespace specula
