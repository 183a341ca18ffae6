#include "tools/generate/record_session.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fw_range_profile.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/truth_range.hpp"

namespace specula {

namespace {

fw_range_config profile_config(const Recipe& recipe) {
    const auto n_samples = static_cast<std::uint16_t>(recipe.radar.chirp.n_samples);
    return {.n_samples = n_samples,
            .first_bin = 0,
            .n_bins = static_cast<std::uint16_t>(fw_range_fft_size(n_samples) / 2),
            .window = recipe.descriptor.window};
}

const char* window_name(fw_window window) {
    return window == FW_WINDOW_BLACKMAN ? "blackman"
           : window == FW_WINDOW_HANN   ? "hann"
                                        : "rectangular";
}

void expect_ok(fw_status status, const char* what, const Recipe& recipe) {
    if (status != FW_OK)
        throw InputError(
            format("{} cannot be taken from frames of {}: {}; choose another "
                   "[descriptor] or store = [\"adc\"]",
                   what, recipe.radar.name, fw_status_name(status)));
}

/// Mean amplitude over chirps of every RX and bin.
void add_profiles(Dataset& frames, const Recipe& recipe) {
    const fw_range_config config = profile_config(recipe);
    const std::size_t bytes = fw_range_profile_scratch(config.n_samples);
    std::vector<float> scratch(bytes / sizeof(float) + 1), row(config.n_bins);
    frames.profile.assign(frames.n_frames() * frames.profile_per_frame(), 0.0f);
    const auto n_chirps = static_cast<std::size_t>(frames.n_chirps);
    const auto n_rx = static_cast<std::size_t>(frames.n_rx);
    for (std::size_t i = 0; i < frames.n_frames() * n_chirps * n_rx; ++i) {  // (frame, chirp, rx)
        const std::size_t frame = i / (n_chirps * n_rx), rx = i % n_rx;
        expect_ok(fw_range_profile(frames.adc.data() + i * config.n_samples, &config,
                                   scratch.data(), scratch.size() * sizeof(float), row.data()),
                  "range profiles", recipe);
        float* const sum = frames.profile.data() + (frame * n_rx + rx) * config.n_bins;
        for (std::size_t bin = 0; bin < config.n_bins; ++bin)
            sum[bin] += row[bin] / static_cast<float>(n_chirps);
    }
}

void add_features(Dataset& frames, const Recipe& recipe) {
    std::vector<float> scratch, row(recipe.descriptor.n_bins);
    for (std::size_t i = 0; i < frames.n_frames(); ++i) {
        const fw_frame frame = frames.frame(i);
        scratch.resize(fw_extract_scratch(&frame) / sizeof(float) + 1);
        expect_ok(fw_extract(&frame, &recipe.descriptor, scratch.data(),
                             scratch.size() * sizeof(float), row.data()),
                  "features", recipe);
        frames.features.insert(frames.features.end(), row.begin(), row.end());
    }
}

/// What is not finite, or not possible, must not reach a file; readers would refuse all of it.
void check_values(const Dataset& frames, std::size_t session) {
    const auto finite = [](auto value) { return std::isfinite(value); };
    if (!std::ranges::all_of(frames.profile, finite) ||
        !std::ranges::all_of(frames.features, finite))
        throw SystemError(
            format("session {}: gives a value that is not finite; this is a fault of "
                   "the program, please report the experiment",
                   session));
    for (const Truth& truth : frames.truth)
        for (std::size_t i = 0; i < truth_columns.size(); ++i)
            if (const std::string problem = truth_problem(i, truth.*truth_columns[i].member);
                !problem.empty())
                throw InputError(format("session {}: {} = {}: {}; choose laws that stay inside",
                                        session, truth_columns[i].name,
                                        truth.*truth_columns[i].member, problem));
}

}  // namespace

Dataset dataset_form(const Recipe& recipe) {
    Dataset form;
    form.origin = {.condition = recipe.condition.name,
                   .experiment = recipe.source,
                   .seed = recipe.seed,
                   .version = program_version,
                   .radar = recipe.radar.name,
                   .bin_m = recipe.radar.chirp.bin_m(),
                   .recipe = recipe.text};
    form.class_names = recipe.population.class_names();
    form.n_chirps = recipe.radar.chirps_per_frame;
    form.n_rx = static_cast<int>(recipe.radar.rx.size());
    form.n_samples = recipe.radar.chirp.n_samples;
    if (recipe.stored.profiles) {
        const fw_range_config config = profile_config(recipe);
        form.n_profile_bins = config.n_bins;
        form.profile_bin_m = form.origin.bin_m * form.n_samples / (2.0 * config.n_bins);
        form.profile_window = window_name(config.window);
    }
    if (recipe.stored.features)
        for (int k = 0; k < recipe.descriptor.n_bins; ++k)
            form.feature_names.push_back(format("bin {}", recipe.descriptor.first_bin + k));
    return form;
}

StoredTables stored_tables(const Recipe& recipe) {
    return {.adc = recipe.stored.adc,
            .adc_quadrature = recipe.stored.adc && recipe.radar.receiver.complex_samples,
            .profile = recipe.stored.profiles,
            .features = recipe.stored.features,
            .unknown_truth = {}};
}

FrameBlock record_session(const Recipe& recipe, const Library& materials, std::size_t number) {
    const auto n_classes = recipe.population.classes.size();
    const auto n_per_class = static_cast<std::size_t>(recipe.condition.sessions_per_class());
    const SessionId id{.world = static_cast<int>(number / (n_classes * n_per_class)),
                       .label = static_cast<int>(number / n_per_class % n_classes),
                       .session = static_cast<int>(number % n_per_class)};
    SessionFrames session = simulate_session(bench_of(recipe, materials), recipe.condition, id);
    Dataset frames = dataset_form(recipe);
    frames.adc = std::move(session.adc);
    frames.adc_quadrature = std::move(session.adc_quadrature);
    frames.truth = std::move(session.truth);
    if (recipe.stored.profiles) add_profiles(frames, recipe);
    if (recipe.stored.features) add_features(frames, recipe);
    if (!recipe.stored.adc) {
        frames.adc.clear();
        frames.adc_quadrature.clear();
    }
    check_values(frames, number);
    return pack_frames(frames, {0, frames.n_frames()});
}

}  // namespace specula
