#pragma once

#include <vector>

#include "tools/study/calibration.hpp"
#include "tools/study/trial.hpp"

namespace specula {

/// What every part of a study works with. Borrows experiment, materials and the calibration.
struct StudyContext {
    const Experiment& experiment;  ///< under the frozen calibration
    const Library& materials;
    const FrozenCalibration& frozen;
    RunSettings run;
    Extent extent;
    std::vector<int> merged;  ///< (class) -> merged class

    Source source() const { return {experiment, materials}; }
    TrialTraining training(std::string_view purpose = "training") const {
        TrialTraining how{.options = experiment.classifier,
                          .seed = run.seed,
                          .purpose = purpose,
                          .threads = run.threads};
        how.options.epochs = extent.epochs;
        return how;
    }
    /// For recordings in passing, which few parts want described for the rungs.
    RunSettings run_with(int worlds) const {
        RunSettings other = run;
        other.worlds = worlds;
        other.kinds.clear();
        return other;
    }
    StreamKey bootstrap() const { return {.seed = run.seed, .purpose = "bootstrap"}; }
    DomainScore score(const std::string& domain, const WorldScores& scores) const;
};

/// The part of every world's rows that is learnt from, and the part that is held back at random.
struct RandomSplits {
    WorldRows training, validation;
};
RandomSplits random_splits(const FeatureTable& rows, const StudyContext& context, int worlds);

}  // namespace specula
