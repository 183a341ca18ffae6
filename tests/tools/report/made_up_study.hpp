#pragma once

#include <cmath>

#include "sim/core/random.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// Numbers that nobody measured: they exercise the report and mean nothing.
struct MadeUpCondition {
    std::string name, title;
    double macro_f1, merged, confidence;
    double shift_bins = 0.0;
};

inline Interval made_up_interval(const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    for (const double v : values) sum += v;
    const double mean = sum / static_cast<double>(values.size());
    for (const double v : values) squares += (v - mean) * (v - mean);
    const double half = 1.96 * std::sqrt(squares) / static_cast<double>(values.size());
    return {mean, mean - half, mean + half};
}

inline std::vector<double> made_up_worlds(double mean, Stream& stream) {
    std::vector<double> worlds(20);
    for (double& world : worlds) world = std::min(1.0, mean + 0.03 * stream.normal());
    return worlds;
}

/// Classes 0 and 1 are taken for each other; the rest spreads over all. Under a shift of bins all
/// goes to the last class.
inline Confusion made_up_confusion(const MadeUpCondition& made_up) {
    constexpr std::size_t n = 5;
    constexpr double n_row = 19200;
    Confusion confusion(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            double share = (1.0 - made_up.merged) / 4.0;
            if (i == j) share = made_up.merged;
            if (i < 2 && j < 2)
                share = i == j ? made_up.merged - 2.4 * (made_up.merged - made_up.macro_f1)
                               : 2.4 * (made_up.merged - made_up.macro_f1);
            if (made_up.shift_bins > 0) share = j == 4 ? 0.92 : j == 3 ? 0.08 : 0.0;
            confusion.at(i, j) =
                static_cast<std::int64_t>(std::lround(n_row * std::max(0.0, share)));
        }
    return confusion;
}

inline ConfidenceHistogram made_up_confidence(const MadeUpCondition& made_up) {
    ConfidenceHistogram histogram;
    for (std::size_t bin = 5; bin < ConfidenceHistogram::n_bins; ++bin) {
        const double below_top = static_cast<double>(ConfidenceHistogram::n_bins - 1 - bin) / 25.0;
        const double tail = 0.4 * (1.0 - made_up.confidence) + 0.01;
        histogram.correct[bin] =
            std::lround(60000 * made_up.macro_f1 * std::exp(-below_top / tail));
        histogram.wrong[bin] =
            std::lround(9000 * (1.0 - made_up.macro_f1) * std::exp(-below_top / (6 * tail)));
    }
    return histogram;
}

inline std::vector<ClassProfile> made_up_features(double shift_bins) {
    const double level[] = {1000, 985, 260, 180, 420};
    std::vector<ClassProfile> classes;
    for (const double peak : level) {
        ClassProfile features;
        for (int bin = 6; bin <= 17; ++bin) {
            double mean = 0.0;
            for (const double side : {-shift_bins, shift_bins})
                mean += 0.5 * peak * std::exp(-std::pow((bin - 12.0 - side) / 1.3, 2)) + 7.0;
            features.mean.push_back(mean);
            features.sd.push_back(shift_bins > 0 ? 0.6 * mean : 0.08 * mean + 2);
        }
        classes.push_back(features);
    }
    return classes;
}

inline StudyCondition made_up_condition(const MadeUpCondition& made_up) {
    Stream stream({.seed = 1, .purpose = made_up.name});
    StudyCondition condition;
    ConditionReport& result = condition.result;
    result.name = made_up.name;
    result.title = made_up.title;
    result.confusion = made_up_confusion(made_up);
    result.confidence = made_up_confidence(made_up);
    result.n_frames = 96000;
    result.macro_f1_per_world = made_up_worlds(made_up.macro_f1, stream);
    result.macro_f1_merged_per_world = made_up_worlds(made_up.merged, stream);
    result.macro_f1 = made_up_interval(result.macro_f1_per_world);
    result.macro_f1_merged = made_up_interval(result.macro_f1_merged_per_world);
    result.mean_confidence = {made_up.confidence, made_up.confidence - 0.006,
                              made_up.confidence + 0.005};
    condition.heights_m = {0.45};
    condition.features = made_up_features(made_up.shift_bins);
    return condition;
}

inline StudySummary made_up_study() {
    StudySummary study;
    study.title =
        "Material classification by 60 GHz radar under geometry shifts: a simulated study";
    study.paper_reference = "A. Author and B. Writer, \u201cA paper\u201d";
    study.class_names = {"iron", "aluminium", "plexiglass", "wood", "limestone"};
    study.merged_classes = {0, 1};
    study.merged_label = "iron and aluminium merged";
    for (const MadeUpCondition& made_up : std::initializer_list<MadeUpCondition>{
             {"nominal", "Nominal (random frames of the training sessions)", 0.946, 0.979, 0.941},
             {"rerecorded", "Nominal, recorded anew", 0.796, 0.967, 0.911},
             {"height", "Height 35 and 55 cm", 0.084, 0.105, 0.997, 2.67},
             {"tilt_sensor", "Sensor tilted -10 and +10 degrees", 0.704, 0.929, 0.910},
             {"tilt_sample", "Sample tilted -10 and +10 degrees about its centre", 0.641, 0.851,
              0.903},
             {"similar", "Similar but unknown samples, new sessions", 0.725, 0.925, 0.895}})
        study.conditions.push_back(made_up_condition(made_up));
    study.conditions[0].paper_macro_f1 = 0.942;
    study.conditions[2].heights_m = {0.35, 0.55};
    study.conditions[3].paper_macro_f1 = 0.685;
    study.radar = {.name = "TI IWRL6432BOOST",
                   .start_frequency_hz = 58e9,
                   .slope_hz_s = 80e12,
                   .sampled_bandwidth_hz = 4e9,
                   .range_bin_m = 0.0375,
                   .nominal_height_m = 0.45,
                   .nominal_height_bin = 12.0,
                   .first_descriptor_bin = 6,
                   .feature_quantity = "magnitude (ADC codes)"};
    study.seed = 7;
    study.version = "0.1.0";
    study.command = "specula study scenes/experiments/hohmann2026.toml --seed 7";
    study.experiment = "scenes/experiments/hohmann2026.toml";
    study.fingerprints = {{"Experiment file", "sha256 8c1f0b7a5d"},
                          {"Data set", "philox 55d2a90c"}};
    return study;
}

}  // namespace specula
