#include "tools/specula/board_options.hpp"

#include "tools/specula/command_options.hpp"

namespace specula {

void add_calibrate(CLI::App& program, CalibrateArguments& arguments) {
    CLI::App* command =
        add_command(program, "calibrate",
                    "Estimate a board's noise, offsets, leakage and gain from a recording",
                    "specula calibrate empty_room.h5 --radar iwrl6432boost --out my_board.toml\n"
                    "  Levels come out in dBm at the RX port and in LSB of the ADC, ranges in mm.");
    command->add_option("RECORDING", arguments.recording, "dataset (.h5), simulated or imported")
        ->required();
    command
        ->add_option("--radar", arguments.radar,
                     "that it was made with: a name, a .toml or a .cfg file")
        ->capture_default_str();
    command->add_option("--scene", arguments.scene,
                        "scene file of what stood there; tells the gain. Default: an empty scene");
    command->add_option("-o,--out", arguments.out, "radar file; default RADAR_calibrated.toml")
        ->type_name("FILE");
}

void add_likeness(CLI::App& program, LikenessArguments& arguments) {
    CLI::App* command =
        add_command(program, "likeness", "Set a radar's simulated chirps beside recorded ones",
                    "specula likeness recording.h5 --radar my_board.toml --out /tmp/likeness\n"
                    "  Writes likeness.svg, .png, .csv and likeness_table.csv, in LSB of the ADC.");
    command->add_option("RECORDING", arguments.recording, "dataset (.h5) of one radar")->required();
    command->add_option("--radar", arguments.radar, "a name, a .toml or a .cfg file")
        ->capture_default_str();
    command->add_option("-o,--out", arguments.out, "folder; default out/likeness")
        ->type_name("FOLDER");
    command->add_option("--seed", arguments.seed, "of the noise")
        ->check(seed_problem)
        ->capture_default_str();
}

}  // namespace specula
