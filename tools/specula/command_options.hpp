#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/specula/commands.hpp"

namespace specula {

/// A sub-command with an example under its help.
CLI::App* add_command(CLI::App& program, const char* name, const char* what, const char* example);

/// CLI::Range takes what is no number, too.
CLI::Validator number_within(double low, double high);

/// What is wrong with a seed; empty: nothing. Reads all of 64 bits; CLI11 would take -1 for
/// 2^64 - 1.
std::string seed_problem(const std::string& text);

/// `--threads`, of which results do not depend.
void add_threads(CLI::App* command, int& threads);

/// `export`, whose own sub-commands are the formats.
CLI::App* export_group(CLI::App& program);

/// The commands that make datasets.
void add_generate(CLI::App& program, GenerateArguments& arguments);
void add_merge(CLI::App& program, MergeArguments& arguments);

/// Speed.
void add_bench(CLI::App& program, BenchArguments& arguments);

/// The commands about recordings.
void add_import(CLI::App& program, ImportArguments& arguments);
void add_export_recording(CLI::App& program, ExportRecordingArguments& arguments);

}  // namespace specula
