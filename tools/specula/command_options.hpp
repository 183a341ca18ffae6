#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/specula/commands.hpp"

namespace specula {

/// A sub-command with an example under its help.
CLI::App* add_command(CLI::App& program, const char* name, const char* what, const char* example);

/// What is wrong with a seed; empty: nothing. Reads all of 64 bits; CLI11 would take -1 for
/// 2^64 - 1.
std::string seed_problem(const std::string& text);

/// `--threads`, of which results do not depend.
void add_threads(CLI::App* command, int& threads);

/// `export`, whose own sub-commands are the formats.
CLI::App* export_group(CLI::App& program);

/// The commands about recordings and the classifiers of them.
void add_bench(CLI::App& program, BenchArguments& arguments);
void add_import(CLI::App& program, ImportArguments& arguments);
void add_export_recording(CLI::App& program, ExportRecordingArguments& arguments);
void add_train(CLI::App& program, TrainArguments& arguments);
void add_evaluate(CLI::App& program, EvaluateArguments& arguments);

}  // namespace specula
