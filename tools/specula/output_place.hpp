#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// Makes the folder of an output, after making sure that writing it destroys nothing that the
/// command reads: throws InputError where `out` is one of `inputs`, by whatever name, or a place
/// that takes no file (check_output_place). Empty inputs are none; a missing one is not this
/// function's business.
/// @in  option  that names the output, as the message calls it
void prepare_output(const std::filesystem::path& out,
                    const std::vector<std::filesystem::path>& inputs,
                    const std::string& option = "--out");

/// Throws InputError where a figure is asked for in a format other than those named, such as ".svg":
/// its name ends in another, and no folder of that name is there.
void check_figure_place(const std::filesystem::path& where,
                        const std::vector<std::string>& formats);

}  // namespace specula
