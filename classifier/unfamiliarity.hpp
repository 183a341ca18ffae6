#pragma once

#include <string>
#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"
#include "classifier/nearest_neighbours.hpp"
#include "classifier/predict.hpp"

namespace specula {

/// What says that an input is none of those a model was trained on. Higher is less familiar.
///
/// max_logit            minus the largest logit (fw_max_logit)
/// softmax_probability  1 - the largest probability: Hendrycks and Gimpel 2017, arXiv 1610.02136
/// energy               -ln(sum exp(logit)) (fw_energy)
/// mahalanobis          squared distance of the inputs from the nearest class, one covariance for
///                      all (fw_mahalanobis_squared)
/// prototypes           distance of the inputs from the nearest prototype
enum class Monitor { max_logit, softmax_probability, energy, mahalanobis, prototypes };

/// In the order of the enumeration, as reports have them.
const std::vector<std::string>& monitor_names();

/// What monitors look at.
struct Observed {
    const FeatureTable& rows;
    const Predictions& predictions;        ///< of those rows
    const InputMonitor* spread = nullptr;  ///< Model::monitor; needed by mahalanobis
    const Prototypes* prototypes = nullptr;
};

/// Scores (row). Throws InputError where the model holds no input monitor, or where a row is too
/// far off for one.
std::vector<double> unfamiliarity(Monitor monitor, const Observed& observed);

}  // namespace specula
