#include <chrono>
#include <cstdio>
#include <optional>

#include "firmware/fw_extract.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/limits.hpp"
#include "sim/link_budget.hpp"
#include "sim/parallel.hpp"
#include "sim/simulate.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/bar_chart.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/output_place.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

Truth truth_of(const Scene& scene) {
    Truth truth;
    truth.height_m = truth.nominal_height_m = scene.pose.height_m;
    truth.sensor_tilt_x_rad = scene.pose.sensor.about_x_rad;
    truth.sensor_tilt_y_rad = scene.pose.sensor.about_y_rad;
    truth.sample_tilt_x_rad = scene.pose.sample.about_x_rad;
    truth.sample_tilt_y_rad = scene.pose.sample.about_y_rad;
    truth.offset_x_m = scene.pose.offset_x_m;
    truth.offset_y_m = scene.pose.offset_y_m;
    truth.yaw_rad = scene.pose.yaw_rad;
    truth.size_x_m = scene.sample.face.size_x_m;
    truth.size_y_m = scene.sample.face.size_y_m;
    truth.thickness_m = scene.sample.thickness_m;
    truth.bow_m = scene.sample.face.bow_m;
    truth.roughness_m = scene.sample.roughness_m;
    truth.correlation_m = scene.sample.correlation_m;
    return truth;
}

Dataset dataset_of(const Scene& scene, const AdcFrame& frame, const SimulateArguments& arguments,
                   const Section& source) {
    Dataset dataset;
    dataset.origin = {.condition = "simulate",
                      .experiment = source.source(),
                      .seed = arguments.seed,
                      .version = program_version,
                      .radar = scene.radar.name,
                      .bin_m = scene.radar.chirp.bin_m(),
                      .recipe = {}};
    dataset.class_names = {scene.sample.title()};
    dataset.n_chirps = frame.n_chirps;
    dataset.n_rx = frame.n_rx;
    dataset.n_samples = frame.n_samples;
    dataset.adc = frame.codes;
    dataset.adc_quadrature = frame.quadrature;
    dataset.truth = {truth_of(scene)};
    return dataset;
}

/// The mean over chirps and RX of the range profile, in LSB.
std::vector<float> range_profile(const AdcFrame& frame, std::uint16_t n_bins) {
    const fw_frame view = frame.view();
    const bool has_window = frame.n_samples == 64 || frame.n_samples == 128 ||
                            frame.n_samples == 256 || frame.n_samples == 512;
    const fw_extract_config config{.first_bin = 0,
                                   .n_bins = n_bins,
                                   .window = has_window ? FW_WINDOW_BLACKMAN : FW_WINDOW_RECT,
                                   .integration = FW_INTEGRATE_MEAN,
                                   .path = FW_RANGE_FLOAT};
    std::vector<float> profile(n_bins);
    std::vector<float> scratch(fw_extract_scratch(&view) / sizeof(float) + 1);
    SPECULA_EXPECT(fw_extract(&view, &config, scratch.data(), scratch.size() * sizeof(float),
                              profile.data()) == FW_OK);
    return profile;
}

/// Enough bins to show the sample with something behind it.
std::uint16_t shown_bins(const Scene& scene) {
    const Chirp& chirp = scene.radar.chirp;
    const int reached = static_cast<int>(chirp.bin_of(scene.pose.height_m)) + 8;
    return static_cast<std::uint16_t>(std::min(std::max(24, reached), chirp.n_samples / 2));
}

constexpr double long_s = 2.0;  ///< from which on a user wants to know how far it is

/// On all processors; with a progress line when the first part foretells a long wait.
void with_progress(std::size_t n, const std::function<void(std::size_t)>& part) {
    if (n == 0) return;
    const auto start = std::chrono::steady_clock::now();
    part(0);
    const std::chrono::duration<double> first = std::chrono::steady_clock::now() - start;
    const int threads = available_threads();
    const double rest_s = first.count() * static_cast<double>(n - 1) / threads;
    std::optional<Progress> progress;
    if (rest_s > long_s) ++progress.emplace("summing the echo", "frequencies", n).done();
    for_each_index(
        n - 1, threads, [&](std::size_t i) { part(i + 1); },
        progress ? &progress->done() : nullptr);
}

}  // namespace

void simulate_command(const SimulateArguments& arguments, const Catalogue& catalogue) {
    const Scene scene = read_scene(arguments.scene, catalogue);
    const Chirp& chirp = scene.radar.chirp;
    const fs::path out =
        arguments.out.empty() ? fs::path(arguments.scene.stem().string() + ".h5") : arguments.out;
    prepare_output(out, {arguments.scene});
    for (const std::string& warning : scene.warnings) say_warning(warning);
    for (const std::string& warning : scene.radar.warnings) say_warning(warning);
    for (const BandWarning& warning : band_warnings(scene, catalogue.materials))
        say_warning(warning.text());
    Stream noise({.seed = arguments.seed, .purpose = "thermal noise"});
    for (const std::string& limit : optics_limits(scene, catalogue.materials)) say_warning(limit);
    const Channel echo = echo_channel(scene, catalogue.materials, with_progress);
    for (const std::string& limit : echo_limits(scene, catalogue.materials, echo))
        say_warning(limit);
    FrameState state;
    state.draw.seed = arguments.seed;
    const AdcFrame frame = record(scene, echo, noise, state);
    write_dataset(out, dataset_of(scene, frame, arguments, Section::read(arguments.scene)));

    const LinkBudget mirror = mirror_budget(scene.radar, scene.pose.height_m);
    std::printf("%s over %s at %.4g mm: bin %.2f of %.4g mm each\n", scene.radar.name.c_str(),
                scene.sample.title().c_str(), scene.pose.height_m * 1e3,
                chirp.bin_of(scene.pose.height_m), chirp.bin_m() * 1e3);
    std::printf("an infinite mirror there: %.1f dBm at the RX, %.0f LSB (IF high-pass %.1f dB)\n\n",
                mirror.received_dbm, mirror.amplitude_lsb, mirror.high_pass_db);
    const std::uint16_t n_bins = shown_bins(scene);
    std::vector<std::string> labels;
    for (int bin = 0; bin < n_bins; ++bin)
        labels.push_back(format("bin {:2} {:6.1f} cm", bin, 100.0 * bin * chirp.bin_m()));
    std::printf("%s\nWrote %s\n", bar_chart(labels, range_profile(frame, n_bins), 0.05).c_str(),
                out.c_str());
}

}  // namespace specula
