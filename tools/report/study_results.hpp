#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "classifier/report.hpp"

namespace specula {

/// Macro-F1 in [0, 1], world by world.
struct WorldScores {
    std::vector<double> all{};
    std::vector<double> merged{};  ///< with classes merged as the experiment says
};

/// Macro-F1 of something in one domain, over worlds.
struct DomainScore {
    std::string domain{};  ///< name of the condition
    Interval all{}, merged{};
    WorldScores per_world{};
};

/// A trial at one signal-to-noise ratio.
struct CalibrationTrial {
    double snr_db = 0.0;  ///< against one frame of the radar file
    double macro_f1 = 0.0;
};

/// The one free scalar, and how it was found from nominal recordings alone.
struct CalibrationOutcome {
    bool asked = false;  ///< else nothing was calibrated, and snr_db is 0
    double target_macro_f1 = 0.0, tolerance = 0.0;
    std::array<double, 2> admissible_snr_db{};
    bool reached = false;  ///< by an admissible value; else snr_db is 0
    double snr_db = 0.0;
    std::optional<CalibrationTrial> matching{};  ///< meets the target, admissible or not
    std::vector<CalibrationTrial> trials{};      ///< in the order they were made
    std::string sha256{};                        ///< of the frozen file; empty until it is frozen
};

/// An interval over fewer worlds than this is hardly one.
inline constexpr std::size_t few_worlds = 4;

/// A statement about the study itself that must hold if its results mean what they say.
struct HonestyCheck {
    std::string name{}, title{};
    Interval value{};                             ///< share in [0, 1]
    std::optional<std::array<double, 2>> band{};  ///< the interval must reach it; none: reported
    bool passed = true;
    std::string reason{};      ///< why the band lies there, or what the number says
    std::size_t n_worlds = 0;  ///< that it rests on
    bool is_of_all_worlds_together = false;  ///< one number, which has no interval over worlds

    /// One world has none either.
    bool has_interval() const { return !is_of_all_worlds_together && n_worlds > 1; }

    /// Passing says little: few worlds, or an interval wider than the band that it had to reach.
    bool is_weak() const {
        return band && (n_worlds < few_worlds ||
                        value.high - value.low > (*band)[1] - (*band)[0]);
    }
};

/// Where the loss from the validation split to a shifted geometry arises.
struct WaterfallStep {
    std::string title{};
    Interval all{}, merged{};
    std::optional<Interval> loss{};  ///< against the step before, paired by worlds; all classes
};

/// The study under one other assumption.
struct SensitivityRow {
    std::string name{}, title{};
    std::vector<DomainScore> domains{};
    std::string fingerprint{};  ///< of all its recordings
};

/// One draw of all assumptions together.
struct PriorDraw {
    std::string what{};
    double nominal = 0.0;  ///< macro-F1 of random frames
    std::vector<double> domains{};
    bool accepted = false;  ///< nominal meets the paper's
};

/// Fewer predictions than this have no percentiles, and nothing is said to agree with them.
inline constexpr std::size_t least_predictions = 5;

/// What the paper's figure is within what the simulator predicts for it.
struct PaperPercentile {
    std::string domain{}, over{};  ///< condition, "worlds" or "prior draws"
    double paper = 0.0;
    std::size_t n = 0;
    double percentile = 0.0;  ///< share of predictions below the paper's figure
    Interval prediction{};    ///< median with the 5th and 95th percentile

    bool has_percentiles() const { return n >= least_predictions; }
    /// From the 5th to the 95th percentile: the one rule by which the report says "agrees".
    bool agrees() const {
        return has_percentiles() && prediction.low <= paper && paper <= prediction.high;
    }
};

struct PriorPrediction {
    std::vector<std::string> domains{};
    std::vector<PriorDraw> draws{};
    double tolerance = 0.0;  ///< on the nominal figure
};

/// One classifier on one cell of the grid.
struct SeverityCell {
    double height_offset_m = 0.0, tilt_rad = 0.0;
    std::string receiver{};  ///< "gain +1 dB", ...; empty: the geometry is what is shifted
    std::vector<double> all{}, merged{};  ///< (classifier), mean over worlds
    std::vector<Interval> intervals{};    ///< (classifier), all classes
};
struct SeverityGrid {
    std::vector<std::string> classifiers{};  ///< the baseline first
    std::vector<double> height_offsets_m{}, tilts_rad{};
    std::vector<SeverityCell> cells{};
    std::vector<double> mean_all{}, mean_merged{};  ///< (classifier), over all shifted cells
    std::vector<double> relative_error{};  ///< (classifier), summed error over the baseline's
    std::size_t n_worlds = 0;
};

/// What a classifier costs on the chip.
struct RungCost {
    std::size_t n_features = 0;
    std::size_t multiplications = 0;  ///< of features and network, per frame
    std::size_t model_bytes = 0;
    double low_us = 0.0, high_us = 0.0;  ///< estimated, of what is beyond the range profile
};

/// One remedy, against the baseline on the same worlds, sessions and steps.
struct LadderRung {
    std::string name{}, title{};
    std::string training{}, descriptor{};
    double budget = 1.0;  ///< rows and steps over the baseline's
    RungCost cost{};
    std::vector<DomainScore> domains{};
    std::vector<Interval> gain{};         ///< (domain), over the baseline, paired by worlds
    std::vector<Interval> gain_merged{};  ///< (domain)
    bool recommended = false;
    /// (domain), over the worlds that had no say in what is recommended; empty: all had.
    std::vector<DomainScore> confirmed{};
};

/// Files of the recommended rung's model, of the first world; below the study's folder.
struct DeviceFiles {
    std::string model{};        ///< as train writes it
    std::string blob{};         ///< for the firmware; empty: it cannot run it
    std::string why_no_blob{};  ///< what the firmware lacks
};

/// How well a score tells frames of a domain from those of the nominal recording made anew.
struct DetectorScore {
    std::string detector{}, domain{};
    Interval auroc{}, fpr95{};
};

/// What a monitor with fallback gives: frames whose inputs are unfamiliar get no answer.
struct FallbackScore {
    std::string domain{};
    Interval answered{};  ///< share of frames
    std::optional<Interval> accuracy{};  ///< of the answered ones; worlds without any left out
    Interval accuracy_all{};
};

/// Answers of about one confidence.
struct ReliabilityPoint {
    double confidence = 0.0;  ///< mean
    Interval accuracy{};      ///< share that is right; worlds resampled
    std::size_t n = 0;        ///< answers
};

/// How far confidence can be believed in one domain, all worlds together.
struct ConfidenceQuality {
    std::string domain{};
    double ece = 0.0, ece_scaled = 0.0;  ///< expected calibration error, raw and with temperature
    double nll = 0.0, brier = 0.0;
    double aurc = 0.0, coverage_at_5_percent = 0.0;
    std::vector<ReliabilityPoint> reliability{};  ///< bins that hold an answer
    std::vector<std::array<double, 2>> risk{};    ///< (point) -> coverage, risk
};

/// How far the inputs of a domain are from those of the training, world by world.
struct InputDrift {
    std::string domain{};
    Interval psi{}, discrepancy{}, mean_shift{};  ///< PSI mean over features; MMD squared; sd
    std::vector<double> psi_per_feature{};        ///< mean over worlds
};

/// All that a study finds beyond its conditions. Empty parts were not asked for.
struct StudyResults {
    CalibrationOutcome calibration{};
    std::vector<WaterfallStep> waterfall{};
    std::vector<HonestyCheck> checks{};
    std::vector<std::string> sensitivity_domains{};
    std::vector<SensitivityRow> sensitivity{};
    PriorPrediction prior{};
    std::vector<PaperPercentile> percentiles{};
    SeverityGrid severity{};
    std::vector<LadderRung> ladder{};
    std::optional<DeviceFiles> device{};
    std::vector<std::size_t> choosing_worlds{};  ///< that decide which rung is recommended
    std::vector<DetectorScore> detectors{};
    std::vector<FallbackScore> fallback{};
    double temperature = 1.0;  ///< fitted on nominal frames, mean over worlds
    std::vector<ConfidenceQuality> confidence{};
    std::vector<InputDrift> drift{};
};

}  // namespace specula
