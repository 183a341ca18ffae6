#include "tools/specula/command_options.hpp"

namespace specula {

void add_generate(CLI::App& program, GenerateArguments& arguments) {
    CLI::App* command = add_command(
        program, "generate", "Simulate a dataset of any size; stopped, it resumes where it was",
        "specula generate tilt_and_height -o tilt_and_height.h5\n"
        "  specula generate paper --condition height -o shards/ --shard 3/8\n"
        "  Run the same command again to resume. Exit status: 130 or 143 when stopped.");
    command
        ->add_option("EXPERIMENT", arguments.experiment,
                     "a dataset or experiment by name (specula list datasets), or a .toml file")
        ->required();
    command
        ->add_option("-o,--out", arguments.out,
                     "FILE.h5, or FOLDER/ for shards and an index; default out/EXPERIMENT.h5. Datasheet "
                     "and Croissant metadata come beside it")
        ->type_name("PATH");
    command->add_option("--condition", arguments.condition,
                        "of an experiment; default its training recordings");
    command->add_option("--seed", arguments.seed, "of all random numbers; default the file's own")
        ->check(seed_problem);
    command->add_option("--worlds", arguments.worlds, "1 to 1000; default the file's own")
        ->check(CLI::Range(1, 1000).description(""));
    command
        ->add_option("--store", arguments.store,
                     "some of adc, profiles and features; default the file's own, or adc")
        ->delimiter(',');
    command->add_option(
        "--shard", arguments.share,
        "INDEX/COUNT, from 0/COUNT: make only this share of the shards, for specula "
        "merge; env: as Slurm or OpenMPI say");
    add_threads(command, arguments.threads);
}

void add_merge(CLI::App& program, MergeArguments& arguments) {
    CLI::App* command =
        add_command(program, "merge", "Make one dataset of the shards of several processes",
                    "specula merge train.h5.parts -o train.h5\n"
                    "  Checks every shard's SHA-256; refuses gaps, overlaps and shards of other "
                    "runs.");
    command->add_option("FOLDER", arguments.folders, "folders that generate --shard wrote")
        ->required();
    command
        ->add_option("-o,--out", arguments.out,
                     "FILE.h5; or the one FOLDER itself, which gets an index")
        ->type_name("PATH")
        ->required();
    add_threads(command, arguments.threads);
}

}  // namespace specula
