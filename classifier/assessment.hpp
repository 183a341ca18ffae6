#pragma once

#include <optional>
#include <string>
#include <vector>

#include "classifier/class_probabilities.hpp"
#include "classifier/detection.hpp"
#include "classifier/drift.hpp"
#include "classifier/feature_table.hpp"
#include "classifier/predict.hpp"
#include "classifier/report.hpp"
#include "classifier/risk_coverage.hpp"
#include "classifier/session_bootstrap.hpp"
#include "classifier/unfamiliarity.hpp"

namespace specula {

/// How a model's answers are assessed.
struct Assessing {
    std::vector<int> merged_class;  ///< as merge_classes takes it; empty: none are merged
    double temperature = 1.0;       ///< fitted on nominal data, see fit_temperature
    Resampling resampling;
};

/// All that one table and the answers to it tell.
struct Assessment {
    std::size_t n_rows = 0;
    std::size_t n_sessions = 0;
    std::size_t n_worlds = 0;
    std::size_t n_worlds_short_of_classes = 0;  ///< that lack a class of which others hold rows
    Confusion confusion;
    double accuracy = 0.0;
    std::vector<std::optional<double>> recall;  ///< (class)
    Interval macro_f1;                          ///< mean over worlds, by bootstrap_sessions
    Interval macro_f1_merged;
    double negative_log_likelihood = 0.0;  ///< nats, at temperature 1
    double brier = 0.0;
    Reliability reliability;         ///< at temperature 1
    Reliability reliability_scaled;  ///< at Assessing::temperature
    double negative_log_likelihood_scaled = 0.0;
    RiskCoverage risk_coverage;  ///< by the largest probability
    double area_under_risk_coverage = 0.0;
    double coverage_at_5_percent_risk = 0.0;
};

/// @in  rows         at least one
/// @in  predictions  of those rows
Assessment assess(const FeatureTable& rows, const Predictions& predictions,
                  const Assessing& how = {});

/// How other data differ from nominal data that were recorded anew: what a monitor would notice.
struct Departure {
    std::vector<Detection> detection;          ///< (monitor), those that the model allows
    std::vector<std::string> monitor;          ///< their names
    std::vector<double> population_stability;  ///< (feature)
    std::vector<double> mean_shift;            ///< (feature), standard deviations
    double mean_discrepancy = 0.0;
};

/// @in  nominal, asked  two rows at least each; the same features
Departure departure_from(const Observed& nominal, const Observed& asked);

}  // namespace specula
