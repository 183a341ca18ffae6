#pragma once

#include <span>

namespace specula {

/// How well a score tells unfamiliar examples from familiar ones.
struct Detection {
    double auroc = 0.5;  ///< [0, 1]; 0.5 is chance, below it the score points the wrong way
    double fpr95 = 1.0;  ///< [0, 1]; 0.95 is chance
};

/// Scores: higher is less familiar.
struct ScorePair {
    std::span<const double> familiar;  ///< the null: nominal data recorded anew, not training rows
    std::span<const double> unfamiliar;  ///< what should be noticed
};

/// auroc: the probability that an unfamiliar example scores above a familiar one, ties a half
/// (Mann and Whitney's U over the number of pairs).
///
/// fpr95: with the limit that passes at least 95 % of the familiar examples, the share of the
/// unfamiliar ones that pass as well. (OpenOOD's "FPR@95", familiar examples being its positives.)
/// @in  scores  at least one on each side, none NaN
Detection detection_of(const ScorePair& scores);

}  // namespace specula
