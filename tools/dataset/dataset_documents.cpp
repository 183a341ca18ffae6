#include "tools/dataset/dataset_documents.hpp"

#include <fstream>
#include <sstream>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/dataset/sha256.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr const char* index_name = "index.h5";
constexpr const char* manifest_name = "manifest.sha256";

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return in ? text.str() : "";
}

/// Refuses to write over a document of another dataset: what somebody wrote about that would be lost.
void check_place(const fs::path& document, const std::string& mark) {
    const std::string there = text_of(document);
    if (!there.empty() && there.find(mark) == std::string::npos)
        throw InputError(document.string() +
                         ": describes another dataset; give another folder with --out, or remove "
                         "it");
}

/// Whether both documents are there and name the bytes that the dataset has now.
bool are_current(const fs::path& dataset, const DocumentFiles& documents) {
    const std::string sheet = text_of(documents.datasheet), json = text_of(documents.croissant);
    if (sheet.empty() || json.empty()) return false;
    const std::string hash = sha256_of_file(dataset);
    if (sheet.find(hash) == std::string::npos || json.find(hash) == std::string::npos) return false;
    return !is_shard_index(dataset) ||
           json.find(sha256_of_file(dataset.parent_path() / manifest_name)) != std::string::npos;
}

}  // namespace

bool is_shard_index(const fs::path& dataset) {
    return dataset.filename() == index_name && fs::exists(dataset.parent_path() / manifest_name);
}

DocumentFiles document_files(const fs::path& dataset, const fs::path& folder) {
    const std::string name = is_shard_index(dataset) ? "" : dataset.stem().string() + ".";
    return {folder / (name + "DATASHEET.md"), folder / (name + "croissant.json")};
}

fs::path write_datasheet(const fs::path& dataset, const fs::path& folder,
                         const DocumentOptions& options, int threads) {
    const fs::path out = document_files(dataset, folder).datasheet;
    check_place(out, datasheet_title(dataset));
    write_file_atomically(out, datasheet_of(dataset, options, threads));
    return out;
}

fs::path write_croissant(const fs::path& dataset, const fs::path& folder,
                         const DocumentOptions& options) {
    const fs::path out = document_files(dataset, folder).croissant;
    check_place(out, croissant_mark(dataset));
    write_file_atomically(out, croissant_of(dataset, options));
    return out;
}

bool write_documents(const fs::path& dataset, int threads) {
    const DocumentFiles documents = document_files(dataset, dataset.parent_path());
    remove_abandoned_drafts(documents.datasheet);
    remove_abandoned_drafts(documents.croissant);
    if (are_current(dataset, documents)) return false;
    check_place(documents.datasheet, datasheet_title(dataset));
    check_place(documents.croissant, croissant_mark(dataset));
    write_file_atomically(documents.datasheet, datasheet_of(dataset, {}, threads));
    write_file_atomically(documents.croissant, croissant_of_whole(dataset, {}));
    return true;
}

}  // namespace specula
