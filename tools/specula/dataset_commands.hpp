#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/catalogue.hpp"
#include "tools/dataset/dataset_diff.hpp"
#include "tools/dataset/dataset_documents.hpp"

namespace specula {

struct DiffArguments {
    std::filesystem::path a, b;
    DiffOptions options;
};
/// The exit status: 0 the same, 1 different.
int diff_command(const DiffArguments& arguments);

struct AugmentArguments {
    std::filesystem::path data;
    std::filesystem::path out;
    std::filesystem::path recipe;    ///< .toml; empty: none
    std::vector<std::string> steps;  ///< as on the command line, "gain=-2:2"
    std::string radar;               ///< a name or a file; empty: the dataset's own
    int copies = 1;
    bool without_originals = false;
    std::uint64_t seed = 1;
    int threads = 1;
};
void augment_command(const AugmentArguments& arguments, const Catalogue& catalogue);

struct DocumentArguments {
    std::string what;  ///< "datasheet" or "croissant"
    std::filesystem::path data;
    std::filesystem::path out;  ///< folder; empty: that of the dataset
    DocumentOptions options;
    int threads = 1;
};
void document_command(const DocumentArguments& arguments);
/// Datasheet and Croissant metadata beside a dataset that a command has finished; a warning where
/// their names are taken.
void describe_written(const std::filesystem::path& dataset, int threads);

}  // namespace specula
