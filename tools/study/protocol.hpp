#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "classifier/train.hpp"
#include "sim/condition.hpp"
#include "sim/population.hpp"
#include "tools/study/assumption.hpp"

namespace specula {

/// How much of an experiment to run. Parts with 0 worlds or draws are left out.
struct Extent {
    int worlds = 1;
    int epochs = 1;
    int seeds = 1;            ///< trainings per world; results are means over them
    int check_worlds = 0;     ///< of the checks that have recordings of their own
    int variant_worlds = 0;   ///< of every other assumption
    int prior_draws = 0;      ///< assumptions drawn at random, one world each
    int severity_worlds = 0;  ///< of the grid
    bool ladder = false;      ///< whether the remedies are compared
};

/// One free scalar, the signal-to-noise ratio, that may be set by nominal recordings alone.
struct CalibrationPlan {
    double target_macro_f1 = 0.0;  ///< of random frames of the training sessions
    double tolerance = 0.01;
    std::array<double, 2> admissible_snr_db{0.0, 20.0};  ///< against one frame of the radar file
    std::array<double, 2> search_snr_db{-40.0, 20.0};    ///< also where it could not be, to say so
};

/// Recordings to learn from beside those of [training].
struct TrainingSet {
    Condition condition;
    std::optional<Distribution> height_m;  ///< law of the height off the condition's, per session
    std::optional<Distribution> tilt_rad;  ///< law of the sample's tilt, each axis
};

/// One remedy: what is learnt from, and what the classifier sees of it.
struct RungPlan {
    std::string name, title;
    std::string training;     ///< "training", or the name of a training set
    std::string descriptor;   ///< as parse_descriptor takes it
    bool motion = false;      ///< learnt and judged on frames recorded in motion
    bool known_gain = false;  ///< features over the true gain: an ideal reference reflector
    double budget = 1.0;      ///< rows and steps over the baseline's
    TrainOptions options;     ///< the experiment's, with what the rung changes

    /// Names the features: rungs of one kind share them.
    std::string kind() const {
        return descriptor + (known_gain ? " over the true gain" : "") +
               (motion ? " in motion" : "");
    }
};

/// Severities of geometry and receiver, against the nominal recording.
struct SeverityPlan {
    std::vector<double> height_offsets_m;  ///< 0 among them
    std::vector<double> tilts_rad;         ///< of the sensor, 0 among them
    std::vector<Assumption> receiver;      ///< gains, ratios and clutter, one each
    int sessions = 1;                      ///< per class and cell
    int frames = 1;
};

/// What a study does beyond recording its conditions and judging one classifier.
struct Protocol {
    std::optional<CalibrationPlan> calibration;
    std::vector<TrainingSet> training_sets;
    std::optional<FrameLaw> motion;  ///< of frames while the sample or the mounting moves
    std::vector<RungPlan> rungs;     ///< the baseline first
    std::vector<Assumption> variants;
    std::vector<std::string> variant_conditions;  ///< that every variant is judged on
    std::optional<SeverityPlan> severity;
    bool checks = false;  ///< [honesty] is there
};

/// The numbers of a preset; what a section leaves out is as in `usual`.
Extent read_extent(Section& section, const Extent& usual);

/// Reads [calibration], [[training_set]], [motion], [[rung]], [[variant]], [severity] and
/// [honesty], all optional.
Protocol read_protocol(Section& root, const Experiment& experiment);

}  // namespace specula
