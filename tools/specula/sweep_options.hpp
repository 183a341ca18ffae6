#pragma once

#include "tools/specula/commands.hpp"

namespace CLI {
class App;
}

namespace specula {

inline constexpr const char* sweep_purpose =
    "Simulate a scene over tilt, height, frequency, material and size; table and plots";

inline constexpr const char* sweep_example =
    "specula sweep scenes/examples/metal_plate.toml --tilt 0:15:0.5 --size 100,150,300 \\\n"
    "      --tilted sample --material aluminium,plexiglass\n"
    "  specula sweep tilt_and_size   (specula list sweeps)\n"
    "  An axis is one value, first:last:step, or several with commas; all are combined.\n"
    "  Writes table.csv, table.h5, and level_over_tilt, _height or _frequency as .svg, .png\n"
    "  and .csv.";

void add_sweep_options(CLI::App& command, SweepArguments& arguments);

}  // namespace specula
