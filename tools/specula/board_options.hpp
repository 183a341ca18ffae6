#pragma once

#include <CLI/CLI.hpp>

#include "tools/specula/commands.hpp"

namespace specula {

/// The commands about a board of one's own.
void add_calibrate(CLI::App& program, CalibrateArguments& arguments);
void add_likeness(CLI::App& program, LikenessArguments& arguments);

}  // namespace specula
