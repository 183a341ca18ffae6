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
/// size and SHA-256, of an index the shards and their manifest too; its tables as fields of a record
/// per frame, its classes. Tables that this program would not read are passed over. The date is that
/// of SOURCE_DATE_EPOCH where it is set, else the file's own. Reads all frames first, so that nothing
/// damaged is described. Throws InputError, SystemError.
std::string croissant_of(const std::filesystem::path& dataset, const DocumentOptions& options);
/// The same of a dataset whose frames were all read just now.
std::string croissant_of_whole(const std::filesystem::path& dataset,
                               const DocumentOptions& options);

/// What a document holds that no document of another dataset does.
std::string datasheet_title(const std::filesystem::path& dataset);
std::string croissant_mark(const std::filesystem::path& dataset);

/// The SHA-256 that the Croissant metadata beside a dataset tell of it; empty: none are there, or they
/// are of another file.
std::string documented_hash(const std::filesystem::path& dataset);

/// Whether a dataset is the index of a folder of shards.
bool is_shard_index(const std::filesystem::path& dataset);

/// The documents of a dataset: NAME.DATASHEET.md and NAME.croissant.json of NAME.h5; of a folder of
/// shards DATASHEET.md and croissant.json.
struct DocumentFiles {
    std::filesystem::path datasheet;
    std::filesystem::path croissant;
};
DocumentFiles document_files(const std::filesystem::path& dataset,
                             const std::filesystem::path& folder);

/// Write a document, whole or not at all, and return its path. Throw InputError where a file of that
/// name describes another dataset.
std::filesystem::path write_datasheet(const std::filesystem::path& dataset,
                                      const std::filesystem::path& folder,
                                      const DocumentOptions& options, int threads);
std::filesystem::path write_croissant(const std::filesystem::path& dataset,
                                      const std::filesystem::path& folder,
                                      const DocumentOptions& options);

/// Writes both beside a dataset, unless they are there and of these very bytes; one pass over the
/// frames. Removes what killed processes left of them. Returns whether it wrote.
bool write_documents(const std::filesystem::path& dataset, int threads);

}  // namespace specula
