#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "classifier/assessment.hpp"

namespace specula {

/// What an evaluation was made of.
struct EvaluationFacts {
    std::string model, data;        ///< files, as given
    std::string fingerprint;        ///< of the data
    bool is_training_data = false;  ///< whether the model learnt from these very frames
    std::string nominal;            ///< file; empty: none
    double temperature = 1.0;
    std::vector<std::string> class_names;
    std::vector<std::string> merged;
};

/// (true, said) -> frames, as rows of an array.
nlohmann::ordered_json confusion_json(const Confusion& confusion);

/// Every number of an evaluation as JSON, with the model's and the data's names.
std::string evaluation_json(const EvaluationFacts& facts, const Assessment& assessment,
                            const std::optional<Departure>& departure);

}  // namespace specula
