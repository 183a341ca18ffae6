#include "tools/serve/rung.hpp"

#include <algorithm>

#include "firmware/fw_extract.h"
#include "firmware/fw_monitor.h"
#include "firmware/fw_normalise.h"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// Bins below are the board's own leakage, whose peak must not be taken for the sample's.
constexpr std::uint16_t first_searched_bin = 5;

/// The peak goes to where the nominal height has it; values below the noise of a bin say nothing.
constexpr fw_normalise_config alignment{.align = true,
                                        .compensate_range = true,
                                        .logarithm = true,
                                        .target_bin = 11.5f,
                                        .floor_lsb = 0.5f};

}  // namespace

std::array<float, 12> rung_features(const RungRecipe& recipe, std::span<const float> profile) {
    std::array<float, 12> features{};
    static_assert(features.size() == FW_DEFAULT_N_BINS);
    if (!recipe.aligned) {
        std::copy_n(profile.begin() + FW_DEFAULT_FIRST_BIN, features.size(), features.begin());
        return features;
    }
    const fw_bins searched{
        .amplitude = profile.data() + first_searched_bin,
        .first_bin = first_searched_bin,
        .n_bins = static_cast<std::uint16_t>(profile.size() - first_searched_bin)};
    SPECULA_EXPECT(fw_normalise(&searched, &alignment, FW_DEFAULT_FIRST_BIN, FW_DEFAULT_N_BINS,
                                features.data()) == FW_OK);
    return features;
}

RungAnswer ask(const Rung& rung, std::span<const float> profile) {
    RungAnswer answer{.features = rung_features(*rung.recipe, profile),
                      .probability = std::vector<float>(rung.folded.n_classes())};
    const auto n_classes = static_cast<std::uint16_t>(rung.folded.n_classes());
    const fw_mlp mlp = rung.folded.view();
    std::vector<float> scratch(fw_mlp_scratch(&mlp) / sizeof(float) + 1);
    std::vector<float> logits(n_classes);
    SPECULA_EXPECT(fw_mlp_run(&mlp, answer.features.data(), scratch.data(),
                              scratch.size() * sizeof(float), logits.data(),
                              answer.probability.data()) == FW_OK);
    answer.max_logit = fw_max_logit(logits.data(), n_classes);
    SPECULA_EXPECT(fw_energy(logits.data(), n_classes, &answer.energy) == FW_OK);
    const InputMonitor& monitor = *rung.model.monitor;
    const fw_mahalanobis spread{.n_features = FW_DEFAULT_N_BINS,
                                .n_classes = n_classes,
                                .mean = monitor.mean.data(),
                                .whitening = monitor.whitening.data(),
                                .centre = monitor.centre.data()};
    SPECULA_EXPECT(
        fw_mahalanobis_squared(&spread, answer.features.data(), &answer.distance_squared) == FW_OK);
    answer.is_familiar = answer.distance_squared <= monitor.suspicious_squared;
    return answer;
}

std::vector<float> whole_profile(const fw_frame& frame) {
    const bool has_window = frame.n_samples == 64 || frame.n_samples == 128 ||
                            frame.n_samples == 256 || frame.n_samples == 512;
    const fw_extract_config config{.first_bin = 0,
                                   .n_bins = static_cast<std::uint16_t>(frame.n_samples / 2),
                                   .window = has_window ? FW_WINDOW_BLACKMAN : FW_WINDOW_RECT,
                                   .integration = FW_INTEGRATE_MEAN,
                                   .path = FW_RANGE_FLOAT};
    std::vector<float> profile(config.n_bins);
    std::vector<float> scratch(fw_extract_scratch(&frame) / sizeof(float) + 1);
    SPECULA_EXPECT(fw_extract(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                              profile.data()) == FW_OK);
    return profile;
}

}  // namespace specula
