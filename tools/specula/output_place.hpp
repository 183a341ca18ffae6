#pragma once

#include <filesystem>
#include <vector>

namespace specula {

/// Makes the folder of an output, after making sure that writing it destroys nothing that the
/// command reads: throws InputError where `out` is one of `inputs`, by whatever name, or a place
/// that takes no file (check_output_place). Empty inputs are none; a missing one is not this
/// function's business.
void prepare_output(const std::filesystem::path& out,
                    const std::vector<std::filesystem::path>& inputs);

}  // namespace specula
