#pragma once

#include <filesystem>

#include "materials/library.hpp"
#include "tools/validate/verdict.hpp"

namespace specula {

struct ValidationRequest {
    std::filesystem::path folder;  ///< or one case file
    int threads = 1;
};

/// Reads all cases, then computes all their points, with a progress line from the second second on.
/// Throws InputError for what is wrong with a file.
Validation validate(const ValidationRequest& request, const Library& library);

}  // namespace specula
