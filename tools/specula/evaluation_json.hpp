#pragma once

#include <optional>
#include <string>

#include "classifier/assessment.hpp"

namespace specula {

/// What an evaluation was made of.
struct EvaluationFacts {
    std::string model, data;  ///< files, as given
    std::string fingerprint;  ///< of the data
    std::string nominal;      ///< file; empty: none
    double temperature = 1.0;
    std::vector<std::string> class_names;
    std::vector<std::string> merged;
};

/// Every number of an evaluation as JSON, with the model's and the data's names.
std::string evaluation_json(const EvaluationFacts& facts, const Assessment& assessment,
                            const std::optional<Departure>& departure);

}  // namespace specula
