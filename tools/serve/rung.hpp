#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classifier/folded_model.hpp"
#include "classifier/predict.hpp"

namespace specula {

/// A step from the paper's classifier to one that keeps its word under other heights and tilts:
/// what its features are, and what it learns from. To add one: a row of `rung_recipes`.
struct RungRecipe {
    const char* name;
    const char* title;
    const char* idea;  ///< for people, one sentence
    bool aligned;      ///< the profile shifted to its peak, times its range, as logarithms
    bool augmented;    ///< learns from other heights and tilts besides the nominal recordings
};

inline constexpr std::array<RungRecipe, 4> rung_recipes{{
    {"paper", "The paper's", "Amplitudes of bins 6 to 17, learnt at 45 cm, looking straight down.",
     false, false},
    {"augmented", "Augmented", "The same amplitudes, learnt at 33 to 57 cm and up to 12 degrees.",
     false, true},
    {"aligned", "Aligned",
     "The profile shifted to its peak, times its range, as logarithms; learnt at 45 cm only.", true,
     false},
    {"aligned_augmented", "Aligned and augmented", "Both: aligned profiles of many geometries.",
     true, true},
}};

/// What a classifier of the recipe sees of a range profile.
/// @in   profile  (bin), LSB, from bin 0, at least 24 bins
/// @out  (feature): LSB, or nepers where aligned
std::array<float, 12> rung_features(const RungRecipe& recipe, std::span<const float> profile);

/// How the training rows of one class spread, feature by feature.
struct ClassBand {
    std::vector<float> low;     ///< (feature), 5th percentile
    std::vector<float> middle;  ///< median
    std::vector<float> high;    ///< 95th percentile
};

/// How good a rung is where it was not trained: macro-F1 over the paper's conditions.
struct RungScore {
    std::string condition;  ///< title
    double macro_f1 = 0.0;
};

struct Rung {
    const RungRecipe* recipe = nullptr;
    Model model;
    std::vector<ClassBand> bands;  ///< (class)
    std::vector<RungScore> scores;
    FoldedModel folded;
};

/// What a rung says of one chirp.
struct RungAnswer {
    std::array<float, 12> features{};
    std::vector<float> probability;  ///< (class)
    float max_logit = 0.0f;
    float energy = 0.0f;            ///< -ln sum exp(logit)
    float distance_squared = 0.0f;  ///< Mahalanobis, to the nearest class
    bool is_familiar = false;       ///< within the 99th percentile of the training rows
};
RungAnswer ask(const Rung& rung, std::span<const float> profile);

/// The range profile of a frame, the mean over its chirps and RX, as the chip computes it.
std::vector<float> whole_profile(const fw_frame& frame);

}  // namespace specula
