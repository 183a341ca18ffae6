#pragma once

#include <filesystem>
#include <string>

#include "tools/report/study_results.hpp"
#include "tools/study/recordings.hpp"

namespace specula {

/// All that a calibration may see: the training recordings, which lie at the nominal geometry, and
/// how well their random frames are told apart. There is no way from here to a shifted geometry.
class NominalSource {
  public:
    /// Borrows all. Throws InputError where [training] is not at the nominal height, untilted.
    NominalSource(const Experiment& experiment, const Library& materials, const RunSettings& run);

    /// Mean over worlds of the macro-F1 of random frames, recorded and trained at this ratio.
    double macro_f1(double snr_db, const Extent& extent) const;

  private:
    const Experiment& experiment_;
    const Library& materials_;
    const RunSettings& run_;
};

/// Bisects the signal-to-noise ratio within what is admissible. Where no admissible value meets the
/// target, the radar file's own ratio stays, and what would meet it is searched for the record, if
/// other assumptions are looked at.
/// Nothing but the nominal figure enters.
CalibrationOutcome calibrate(const CalibrationPlan& plan, const NominalSource& nominal,
                             const Extent& extent);

/// A calibration that lies on disk and will not change. Whoever records another geometry has to
/// show one, and only freeze_calibration makes them.
class FrozenCalibration {
  public:
    const CalibrationOutcome& outcome() const { return outcome_; }

  private:
    friend FrozenCalibration freeze_calibration(const CalibrationOutcome& outcome,
                                                const std::filesystem::path& file);
    explicit FrozenCalibration(CalibrationOutcome outcome) : outcome_(std::move(outcome)) {}
    CalibrationOutcome outcome_;
};

/// Writes the outcome as JSON, whole or not at all, and gives it the SHA-256 of that file's bytes.
FrozenCalibration freeze_calibration(const CalibrationOutcome& outcome,
                                     const std::filesystem::path& file);

}  // namespace specula
