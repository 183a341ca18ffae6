#pragma once

#include <filesystem>
#include <string>

namespace specula {

/// What nobody but the maker of a dataset can say; empty: it is not told.
struct DocumentOptions {
    std::string license;  ///< URL or name
    std::string creator;
    std::string url;  ///< where the dataset is found
};

/// The text of a datasheet for a dataset, after Gebru et al., "Datasheets for Datasets" (2021):
/// motivation, composition, collection, preprocessing, uses, distribution, maintenance, with the
/// numbers of the file itself. Throws InputError as DatasetReader does.
std::string datasheet_of(const std::filesystem::path& dataset, const DocumentOptions& options,
                         int threads);

/// The text of Croissant metadata 1.0 (JSON-LD, http://mlcommons.org/croissant/1.0): the file with
/// size and SHA-256, its tables as fields of a record per frame, its classes. The date is that of
/// SOURCE_DATE_EPOCH where it is set, else the file's own. Throws InputError, SystemError.
std::string croissant_of(const std::filesystem::path& dataset, const DocumentOptions& options);

/// Writes DATASHEET.md and croissant.json, whole or not at all, and returns the path. Throws
/// InputError where the folder's file of that name describes another dataset.
std::filesystem::path write_datasheet(const std::filesystem::path& dataset,
                                      const std::filesystem::path& folder,
                                      const DocumentOptions& options, int threads);
std::filesystem::path write_croissant(const std::filesystem::path& dataset,
                                      const std::filesystem::path& folder,
                                      const DocumentOptions& options);

}  // namespace specula
