#include "tools/specula/sweep_options.hpp"

#include <CLI/CLI.hpp>

#include "tools/specula/command_options.hpp"

namespace specula {

namespace {

void add_axes(CLI::App& command, SweepAxes& axes) {
    command.add_option("--tilt", axes.tilt, "degrees, within 85; default the scene's")
        ->type_name("DEG|A:B:STEP");
    command.add_option("--height", axes.height, "mm, phase centre over the untilted face")
        ->type_name("MM|A:B:STEP");
    command
        .add_option("--freq", axes.frequency,
                    "GHz: levels at these instead of the mean over the chirp; no range bins then")
        ->type_name("GHZ|A:B:STEP");
    command.add_option("--tilted", axes.tilted, "sample (about the pivot), sensor, or both")
        ->type_name("WHAT");
    command.add_option("--tilt-plane", axes.tilt_plane, "azimuth, elevation, or both")
        ->type_name("PLANE");
    command.add_option("--material", axes.material, "names with commas (specula list materials)")
        ->type_name("M1,M2");
    command.add_option("--size", axes.size, "mm, edge of a square sample")
        ->type_name("MM|A:B:STEP");
    command.add_option("--thickness", axes.thickness, "mm")->type_name("MM|A:B:STEP");
    command.add_option("--roughness", axes.roughness, "micrometres rms")->type_name("UM|A:B:STEP");
    command.add_option("--correlation", axes.correlation, "mm, of the rough face's heights")
        ->type_name("MM|A:B:STEP");
    command
        .add_option("--plot", axes.plot,
                    "what is drawn: received_dbm, over_mirror_db, over_untilted_db, "
                    "over_nominal_db")
        ->type_name("LEVEL");
}

}  // namespace

void add_sweep_options(CLI::App& command, SweepArguments& arguments) {
    command.add_option("SCENE", arguments.what, "scene or sweep file (.toml), or a sweep's name")
        ->required();
    add_axes(command, arguments.axes);
    command.add_option("-o,--out", arguments.out, "folder to write; default out/sweep/SCENE")
        ->type_name("FOLDER");
    add_threads(&command, arguments.threads);
}

}  // namespace specula
