#include "tools/specula/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/parallel.hpp"
#include "tools/console/console.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/specula/board_options.hpp"
#include "tools/specula/command_options.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/dataset_options.hpp"
#include "tools/specula/firmware_options.hpp"
#include "tools/specula/freed_memory.hpp"
#include "tools/specula/home.hpp"
#include "tools/specula/learning_options.hpp"
#include "tools/specula/printed_output.hpp"
#include "tools/specula/serve_options.hpp"
#include "tools/specula/sweep_options.hpp"

namespace specula {

namespace {

constexpr const char* about =
    "Specula: a simulator of 60 GHz FMCW radar over planar material samples.\n"
    "Lengths, angles and frequencies in files carry their unit in the key (height_mm, tilt_deg).";

constexpr const char* first_steps =
    "Begin with:\n"
    "  specula simulate scenes/examples/metal_plate.toml\n"
    "  specula study --quick\n"
    "\"specula study --help\" explains one command. Exit status: 0 done, 1 the system failed "
    "(disk,\n"
    "memory, a missing tool), 2 wrong input.";

void add_study(CLI::App& program, StudyArguments& arguments) {
    CLI::App* command = add_command(
        program, "study",
        "Run an experiment: record, train, judge, report (two to five minutes for the paper's, on "
        "two cores)",
        "specula study paper --out /tmp/paper --threads 2\n"
        "  Writes report.html, results.json, figures/, datasets/*.h5, models/ and firmware/.");
    command
        ->add_option("EXPERIMENT", arguments.experiment,
                     "a name (specula list experiments) or a .toml file")
        ->capture_default_str();
    command->add_option("-o,--out", arguments.out, "folder to write; default out/EXPERIMENT")
        ->type_name("FOLDER");
    command
        ->add_option("--seed", arguments.seed,
                     "of all random numbers; default the experiment's own")
        ->check(seed_problem);
    add_threads(command, arguments.threads);
    CLI::Option* quick =
        command->add_flag("--quick", arguments.quick, "the experiment's small version, about 10 s");
    command
        ->add_flag("--full", arguments.full,
                   "its large version: more worlds, trainings and assumptions, some five minutes")
        ->excludes(quick);
}

void add_simulate(CLI::App& program, SimulateArguments& arguments) {
    CLI::App* command =
        add_command(program, "simulate", "Simulate one frame of a scene file",
                    "specula simulate scenes/examples/metal_plate.toml --out plate.h5\n"
                    "  Writes the ADC codes in LSB, and prints the range profile and link budget.");
    command
        ->add_option("SCENE", arguments.scene, "scene file (.toml; scenes/README.md has its keys)")
        ->required();
    command->add_option("-o,--out", arguments.out, "dataset to write; default SCENE.h5 here")
        ->type_name("FILE");
    command->add_option("--seed", arguments.seed, "of the thermal noise")
        ->check(seed_problem)
        ->capture_default_str();
}

void add_show(CLI::App& program, std::vector<std::string>& words, ShowArguments& arguments) {
    CLI::App* command = add_command(
        program, "show", "Explain a material, a radar, an experiment, a scene or a dataset",
        "specula show material plexiglass --figure /tmp/figures\n"
        "  specula show out/paper/datasets/height.h5 --figure height.svg");
    command
        ->add_option("NAME", words,
                     "a name (specula list), a .toml, .cfg or .h5 file; the kind may stand before "
                     "it: material, radar, experiment, sweep")
        ->required()
        ->expected(1, 2);
    command
        ->add_option(
            "--figure", arguments.figure,
            "draw what a material reflects, or what is in a dataset: a folder for SVG, PNG "
            "and CSV; of a dataset also one .svg or .png file")
        ->type_name("WHERE");
}

/// "plexiglass", or with its kind before it: "material plexiglass".
ShowArguments with_words(ShowArguments arguments, const std::vector<std::string>& words) {
    arguments.what = words.back();
    if (words.size() == 1) return arguments;
    const std::vector<std::string> kinds{"material", "radar", "experiment", "sweep"};
    arguments.kind = words.front();
    if (std::find(kinds.begin(), kinds.end(), arguments.kind) == kinds.end())
        throw InputError(format("\"{}\": no kind of thing to show; use {} before a name",
                                arguments.kind, quoted_list(kinds)));
    return arguments;
}

void add_validate(CLI::App& program, ValidateArguments& arguments) {
    CLI::App* command = add_command(
        program, "validate", "Compute reference cases and compare with what they expect",
        "specula validate --html validation.html\n"
        "  Exit status: 1 where a tolerance is missed, 3 where nothing computes a case.");
    command->add_option("DIR", arguments.folder,
                        "folder of case files, or one of them; default the program's own");
    command->add_option("--json", arguments.json, "write every quantity")->type_name("FILE");
    command->add_option("--html", arguments.html, "write a page with error plots")
        ->type_name("FILE");
    add_threads(command, arguments.threads);
}

/// One line on standard error, whatever the names of files in it hold.
void complain(std::string problem) {
    for (char& c : problem)
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    say_error(problem);
}

/// What is wrong with the arguments, and what would do.
std::string usage_problem(const CLI::App& program, const CLI::ParseError& error,
                          const std::string& first_argument) {
    const auto chosen = program.get_subcommands();
    if (!chosen.empty())
        return format("{}; see specula {} --help", error.what(), chosen.front()->get_name());
    if (first_argument.empty() || first_argument[0] == '-')
        return format("{}; see specula --help", error.what());
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    const std::string near = nearest_word(first_argument, names);
    return format("\"{}\": no such command; {}use {}", first_argument,
                  near.empty() ? "" : "did you mean " + near + "? ", quoted_list(names));
}

/// An empty name is a variable of a script that was not set, not a wish for the default.
void refuse_empty_outputs(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands({})) {
        refuse_empty_outputs(*command);
        for (const char* name : {"--out", "--figure"})
            if (CLI::Option* out = command->get_option_no_throw(name))
                out->check([](const std::string& given) {
                    return given.empty() ? std::string("is empty; name a file or a folder") : "";
                });
    }
}

}  // namespace

int run_program(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    keep_freed_memory();

    CLI::App program{about, "specula"};
    program.footer(first_steps);
    program.set_version_flag("--version", std::string("specula ") + program_version);
    program.require_subcommand(1);
    StudyArguments study;
    study.threads = available_threads();
    add_study(program, study);
    GenerateArguments generation;
    generation.threads = available_threads();
    add_generate(program, generation);
    MergeArguments merging;
    merging.threads = available_threads();
    add_merge(program, merging);
    SimulateArguments simulate;
    add_simulate(program, simulate);
    ShowArguments show;
    std::vector<std::string> shown;
    add_show(program, shown, show);
    SweepArguments sweep;
    sweep.threads = available_threads();
    add_sweep_options(*add_command(program, "sweep", sweep_purpose, sweep_example), sweep);
    ValidateArguments validation;
    validation.threads = available_threads();
    add_validate(program, validation);
    BenchArguments bench;
    bench.threads = available_threads();
    add_bench(program, bench);
    ImportArguments import;
    add_import(program, import);
    ExportRecordingArguments export_;
    add_export_recording(program, export_);
    TrainArguments training;
    training.learning.threads = available_threads();
    add_train(program, training);
    EvaluateArguments evaluation;
    evaluation.learning.threads = available_threads();
    add_evaluate(program, evaluation);
    PredictArguments prediction;
    prediction.threads = available_threads();
    add_predict(program, prediction);
    FirmwareArguments firmware;
    add_firmware_commands(program, firmware);
    CalibrateArguments calibration;
    add_calibrate(program, calibration);
    LikenessArguments likeness;
    add_likeness(program, likeness);
    DatasetArguments datasets;
    add_dataset_commands(program, datasets);
    ServeArguments serving;
    serving.threads = available_threads();
    add_serve(program, serving);
    std::string listed, shell = "bash";
    add_command(program, "list", "List what is known by name", "specula list materials")
        ->add_option("KIND", listed, "materials, radars, experiments, datasets or sweeps")
        ->required()
        ->check(CLI::IsMember({"materials", "radars", "experiments", "datasets", "sweeps"})
                    .description(""));
    add_command(program, "completion", "Print a completion script for a shell",
                "eval \"$(specula completion bash)\"")
        ->add_option("SHELL", shell, "bash or zsh")
        ->check(CLI::IsMember({"bash", "zsh"}).description(""))
        ->capture_default_str();

    refuse_empty_outputs(program);

    try {
        program.parse(argc, argv);
        int status = 0;
        const std::string command = program.get_subcommands().front()->get_name();
        if (command == "completion") {
            std::vector<std::string> names;
            for (const CLI::App* each : program.get_subcommands({}))
                names.push_back(each->get_name());
            completion_command(shell, names);
        } else {
            const Catalogue catalogue = Catalogue::open(home_folder());
            if (command == "study") study_command(study, catalogue);
            if (command == "generate") generate_command(generation, catalogue);
            if (command == "merge") merge_command(merging);
            if (command == "simulate") simulate_command(simulate, catalogue);
            if (command == "sweep") sweep_command(sweep, catalogue);
            if (command == "calibrate") calibrate_command(calibration, catalogue);
            if (command == "likeness") likeness_command(likeness, catalogue);
            if (command == "validate") status = validate_command(validation, catalogue);
            if (command == "bench") bench_command(bench, catalogue);
            if (command == "serve") serve_command(serving, catalogue);
            if (command == "import") import_command(import, catalogue);
            if (command == "export" && !export_.what.empty())
                export_recording_command(export_, catalogue);
            if (command == "train") train_command(training, catalogue);
            if (command == "evaluate") evaluate_command(evaluation, catalogue);
            if (command == "predict") predict_command(prediction, catalogue);
            if (is_dataset_command(program))
                status = run_dataset_command(program, datasets, catalogue);
            else if (is_firmware_command(command) && export_.what.empty())
                status = run_firmware_command(program, firmware, catalogue);
            if (command == "list") list_command(listed, catalogue);
            if (command == "show") show_command(with_words(show, shown), catalogue);
        }
        flush_printed_output();
        return status;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        complain(usage_problem(program, error, argc > 1 ? argv[1] : ""));
        return 2;
    } catch (const Interrupted& stop) {
        complain(stop.what());
        return stop.exit_status();
    } catch (const InputError& error) {
        complain(error.what());
        return 2;
    } catch (const std::filesystem::filesystem_error& error) {
        complain(error.path1().string() + ": " + error.code().message() + "; give another name");
        return error.code() == std::errc::filename_too_long ? 2 : 1;
    } catch (const std::bad_alloc&) {
        complain("out of memory; run fewer worlds or sessions at once");
        return 1;
    } catch (const std::exception& error) {  // SystemError and our own mistakes
        complain(error.what());
        return 1;
    }
}

}  // namespace specula
