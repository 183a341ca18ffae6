#include "tools/specula/dataset_options.hpp"

#include "sim/parallel.hpp"
#include "tools/specula/command_options.hpp"

namespace specula {

namespace {

void add_diff(CLI::App& program, DiffArguments& arguments) {
    CLI::App* command = add_command(
        program, "diff", "Compare two datasets, table by table, and name the first difference",
        "specula diff here.h5 there.h5 --ignore @software_version --lsb 1\n"
        "  Exit status: 0 the same, 1 different, 2 a file cannot be read.");
    command->add_option("A", arguments.a, "dataset (.h5)")->required();
    command->add_option("B", arguments.b, "dataset (.h5)")->required();
    command
        ->add_option("--ignore", arguments.options.ignored,
                     "tables (/truth/bow_m), groups (/truth) or attributes (@seed), by commas")
        ->delimiter(',')
        ->type_name("NAMES");
    command
        ->add_option("--lsb", arguments.options.tolerance_lsb,
                     "let ADC codes be apart by so much, in LSB; 1 between kinds of processors")
        ->check(number_within(0.0, 65535.0))
        ->type_name("LSB");
    command
        ->add_option("--relative", arguments.options.relative,
                     "let floating-point values be apart by this share of the larger")
        ->check(number_within(0.0, 1.0))
        ->type_name("SHARE");
}

void add_augment(CLI::App& program, AugmentArguments& arguments) {
    CLI::App* command = add_command(
        program, "augment", "Write a dataset with changed copies of its frames",
        "specula augment boards.h5 -o more.h5 --copies 4 --step noise=0:3 --step gain=-1:1\n"
        "  specula augment boards.h5 -o more.h5 --recipe scenes/augmentation/bench.toml\n"
        "  Steps: noise (LSB), gain (dB), leakage (LSB), clutter (LSB), shift (mm, level kept),\n"
        "  range (mm, level as of a mirror); VALUE, or LOW:HIGH for a uniform law. Groups are "
        "kept,\n"
        "  so that a copy never leaves its original's side of a split.");
    command->add_option("DATASET", arguments.data, "dataset (.h5): codes or features")->required();
    command
        ->add_option("-o,--out", arguments.out,
                     "dataset to write; datasheet and Croissant metadata come beside it")
        ->required()
        ->type_name("FILE");
    command->add_option("--recipe", arguments.recipe, "steps as [[step]] of a .toml file")
        ->type_name("FILE");
    command->add_option("--step", arguments.steps, "NAME=VALUE or NAME=LOW:HIGH; may come again")
        ->type_name("STEP");
    command
        ->add_option("--radar", arguments.radar,
                     "whose chirp and IF high-pass hold: a name or a file; default the dataset's")
        ->type_name("NAME");
    command->add_option("--copies", arguments.copies, "of each frame, 1 to 1000")
        ->check(CLI::Range(1, 1000).description(""))
        ->capture_default_str();
    command->add_flag("--without-originals", arguments.without_originals,
                      "write the changed copies only");
    command->add_option("--seed", arguments.seed, "of all random numbers")
        ->check(seed_problem)
        ->capture_default_str();
    add_threads(command, arguments.threads);
}

void add_documents(CLI::App& program, DocumentArguments& arguments) {
    for (const auto& [name, what] :
         {std::pair{"datasheet",
                    "NAME.DATASHEET.md: what a dataset holds, how it came about, its limits"},
          {"croissant",
           "NAME.croissant.json: the same for machines (JSON-LD of MLCommons, with sha256)"}}) {
        CLI::App* command = export_group(program)->add_subcommand(name, what);
        command->footer(std::string("Example:\n  specula export ") + name +
                        " boards.h5 --license https://spdx.org/licenses/CC-BY-4.0 "
                        "--creator \"A. Name\"");
        command->callback([&arguments, name = name] { arguments.what = name; });
        command->add_option("DATASET", arguments.data, "dataset (.h5)")->required();
        command->add_option("-o,--out", arguments.out, "folder to write to; default the dataset's")
            ->type_name("FOLDER");
        command
            ->add_option("--license", arguments.options.license, "URL or name; default: not told")
            ->type_name("TEXT");
        command
            ->add_option("--creator", arguments.options.creator, "who made it; default: not told")
            ->type_name("TEXT");
        command
            ->add_option("--url", arguments.options.url, "where it is found; default: this folder")
            ->type_name("URL");
        add_threads(command, arguments.threads);
    }
}

}  // namespace

void add_dataset_commands(CLI::App& program, DatasetArguments& arguments) {
    arguments.augment.threads = arguments.documents.threads = available_threads();
    add_diff(program, arguments.diff);
    add_augment(program, arguments.augment);
    add_documents(program, arguments.documents);
}

bool is_dataset_command(const CLI::App& program) {
    const CLI::App* const command = program.get_subcommands().front();
    const std::string name = command->get_name();
    if (name == "diff" || name == "augment") return true;
    if (name != "export" || command->get_subcommands().empty()) return false;
    const std::string what = command->get_subcommands().front()->get_name();
    return what == "datasheet" || what == "croissant";
}

int run_dataset_command(const CLI::App& program, const DatasetArguments& arguments,
                        const Catalogue& catalogue) {
    const std::string name = program.get_subcommands().front()->get_name();
    if (name == "diff") return diff_command(arguments.diff);
    if (name == "augment")
        augment_command(arguments.augment, catalogue);
    else
        document_command(arguments.documents);
    return 0;
}

}  // namespace specula
