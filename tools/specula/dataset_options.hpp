#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "scenes/catalogue.hpp"
#include "tools/specula/dataset_commands.hpp"

namespace specula {

/// The commands on files of datasets.
struct DatasetArguments {
    DiffArguments diff;
    AugmentArguments augment;
    DocumentArguments documents;
};
void add_dataset_commands(CLI::App& program, DatasetArguments& arguments);

/// Whether one of them was asked for.
bool is_dataset_command(const CLI::App& program);
/// Runs it; the exit status.
int run_dataset_command(const CLI::App& program, const DatasetArguments& arguments,
                        const Catalogue& catalogue);

}  // namespace specula
