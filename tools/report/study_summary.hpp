#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "classifier/report.hpp"
#include "tools/report/class_profile.hpp"
#include "tools/report/study_results.hpp"

namespace specula {

/// Names of conditions that the report has something to say about. Others are tabulated too.
inline constexpr std::string_view nominal_condition = "nominal";
inline constexpr std::string_view rerecorded_condition = "rerecorded";
inline constexpr std::string_view height_condition = "height";
inline constexpr std::string_view tilt_sensor_condition = "tilt_sensor";
inline constexpr std::string_view tilt_sample_condition = "tilt_sample";
inline constexpr std::string_view similar_condition = "similar";
inline constexpr std::string_view joint_condition = "joint";

struct StudyCondition {
    ConditionReport result;                ///< worlds in the same order in every condition
    std::optional<double> paper_macro_f1;  ///< in [0, 1]; empty: the paper gives no number
    std::vector<double> heights_m;         ///< heights of the radar that occur
    std::vector<ClassProfile> features;  ///< (class), all frames of all worlds; empty: not recorded
};

struct RadarFacts {
    std::string name;                 ///< e.g. "TI IWRL6432BOOST"
    double start_frequency_hz = 0.0;  ///< of the sampled part of the chirp
    double slope_hz_s = 0.0;
    double sampled_bandwidth_hz = 0.0;
    double range_bin_m = 0.0;  ///< spacing of range bins
    double nominal_height_m = 0.0;
    double nominal_height_bin =
        0.0;  ///< where the echo of the nominal height lies; may be between bins
    int first_descriptor_bin = 0;  ///< range bin of the first feature
    std::string feature_quantity;  ///< axis of the descriptor, e.g. "magnitude (ADC codes)"
};

/// A free parameter that was set so that one condition meets the paper. Its agreement is then by
/// construction, and the report says so.
struct Calibration {
    std::string condition;  ///< name of that condition
    std::string parameter;  ///< for people, e.g. "the effective signal-to-noise ratio"
};

/// All that the report of the study states. It holds no date and no duration: the same seed gives
/// the same report, byte for byte.
struct StudySummary {
    std::string title;            ///< of the page
    std::string paper_reference;  ///< authors, title, where; empty: not printed
    std::vector<StudyCondition> conditions;
    std::vector<StudyCondition> parts;        ///< single heights and tilts of conditions of several
    StudyResults results;                     ///< what was asked beyond the conditions
    int repeats = 1;                          ///< trainings per world
    std::vector<std::string> class_names;     ///< (class)
    std::vector<std::size_t> merged_classes;  ///< classes that count as one in `merged` figures
    std::string merged_label;                 ///< for people, e.g. "iron and aluminium merged"
    RadarFacts radar;
    std::optional<Calibration> calibration;
    std::vector<std::string> warnings;  ///< where numbers are used beyond what they are known for

    std::uint64_t seed = 0;
    std::string version;                                            ///< of the program
    std::string command;                                            ///< that repeats the study
    std::string experiment;                                         ///< path of the experiment file
    std::vector<std::pair<std::string, std::string>> fingerprints;  ///< what was hashed, hash
};

/// The condition of that name, or nullptr.
inline const StudyCondition* find_condition(const StudySummary& study, std::string_view name) {
    for (const StudyCondition& condition : study.conditions)
        if (condition.result.name == name) return &condition;
    return nullptr;
}

}  // namespace specula
