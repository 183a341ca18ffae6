#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "sim/core/error.hpp"

namespace specula {

/// A document beside a dataset, and the text in it that says which dataset it is of.
struct DocumentName {
    std::string name;
    std::string mark;
};

/// Where the document goes. Throws InputError where one of another dataset is in its place: what
/// somebody wrote about that would be lost.
inline std::filesystem::path document_in(const std::filesystem::path& folder,
                                         const DocumentName& document) {
    const std::filesystem::path file = folder / document.name;
    std::ifstream in(file, std::ios::binary);
    std::stringstream there;
    there << in.rdbuf();
    if (in && there.str().find(document.mark) == std::string::npos)
        throw InputError(file.string() +
                         ": describes another dataset; give another folder with --out, or remove "
                         "it");
    return file;
}

}  // namespace specula
