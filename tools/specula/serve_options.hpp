#pragma once

#include <CLI/CLI.hpp>

#include "tools/specula/commands.hpp"

namespace specula {

void add_serve(CLI::App& program, ServeArguments& arguments);

}  // namespace specula
