#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/validate/fields.hpp"

namespace specula {

/// A file of the reference folder: points {inp, expect}, and how far off is near enough. Its
/// README.md explains the schema.
struct CaseFile {
    std::filesystem::path path;
    std::string id;     ///< "M03_slab"
    std::string title;  ///< for people
    std::string level;  ///< how trustworthy the expectation is; may be empty
    std::size_t n_points = 0;
    std::shared_ptr<const nlohmann::json> document;

    /// What tells the kind: the id up to its first '_'.
    std::string kind() const { return id.substr(0, id.find('_')); }

    Fields inp(std::size_t point) const;
    Fields expect(std::size_t point) const;
    Fields tolerance() const;
    /// What the points that give `inp.name` all agree upon.
    std::optional<double> agreed_number(const std::string& name) const;
};

/// Throws InputError `file: field = value: problem; remedy` for what is no case.
CaseFile read_case_file(const std::filesystem::path& path);

struct CaseFolder {
    std::vector<CaseFile> cases;      ///< by file name
    std::vector<std::string> others;  ///< JSON files that are no cases: neither id nor points
};

/// All *.json of a folder, or a single case file. Throws InputError where there is no case.
CaseFolder read_case_folder(const std::filesystem::path& folder);

}  // namespace specula
