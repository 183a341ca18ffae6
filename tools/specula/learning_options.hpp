#pragma once

#include <CLI/CLI.hpp>

#include "tools/specula/commands.hpp"

namespace specula {

/// The commands that train, judge and use classifiers.
void add_train(CLI::App& program, TrainArguments& arguments);
void add_evaluate(CLI::App& program, EvaluateArguments& arguments);
void add_predict(CLI::App& program, PredictArguments& arguments);

}  // namespace specula
