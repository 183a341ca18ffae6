#pragma once

#include "tools/specula/commands.hpp"

namespace specula {

/// Cross-validates a dataset for every split asked for, and prints the scores.
void evaluate_left_out(const EvaluateArguments& arguments);

}  // namespace specula
