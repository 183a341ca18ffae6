#include "tools/specula/command_line.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <new>

#include "sim/core/error.hpp"
#include "sim/core/version.hpp"
#include "sim/parallel.hpp"
#include "tools/specula/commands.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/home.hpp"

namespace specula {

namespace {

constexpr const char* about =
    "Specula: a simulator of 60 GHz FMCW radar over planar material samples.\n"
    "Lengths, angles and frequencies in files carry their unit in the key (height_mm, tilt_deg).";

/// A sub-command with an example under its help.
CLI::App* add_command(CLI::App& program, const char* name, const char* what, const char* example) {
    CLI::App* command = program.add_subcommand(name, what);
    command->footer(std::string("\nExample:\n  ") + example);
    return command;
}

void add_study(CLI::App& program, StudyArguments& arguments) {
    CLI::App* command = add_command(
        program, "study",
        "Run an experiment: record, train, judge, report (two minutes for the paper's)",
        "specula study paper --out /tmp/paper --threads 2\n"
        "  Writes report.html, results.json, figures/, datasets/*.h5, models/ and firmware/.");
    command->add_option("experiment", arguments.experiment,
                        "name of an experiment (specula list experiments) or a .toml file")
        ->capture_default_str();
    command->add_option("-o,--out", arguments.out, "folder to write; default out/EXPERIMENT");
    command->add_option("--seed", arguments.seed, "instead of the experiment's own");
    command->add_option("-j,--threads", arguments.threads, "1 to 1024; results do not depend on it")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_flag("--quick", arguments.quick, "the experiment's small version, about 15 s");
}

void add_simulate(CLI::App& program, SimulateArguments& arguments) {
    CLI::App* command =
        add_command(program, "simulate", "Simulate one frame of a scene file",
                    "specula simulate scenes/examples/metal_plate.toml --out plate.h5\n"
                    "  Writes the ADC codes, and prints the range profile and link budget.");
    command->add_option("scene", arguments.scene, "scene file (.toml)")->required();
    command->add_option("-o,--out", arguments.out, "dataset to write; default SCENE.h5 here");
    command->add_option("--seed", arguments.seed, "of the thermal noise")->capture_default_str();
}

}  // namespace

int run_program(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);

    CLI::App program{about, "specula"};
    program.set_version_flag("--version", std::string("specula ") + program_version);
    program.require_subcommand(1);
    StudyArguments study;
    study.threads = available_threads();
    add_study(program, study);
    SimulateArguments simulate;
    add_simulate(program, simulate);
    std::string listed, shown, shell = "bash";
    add_command(program, "list", "List what is known by name", "specula list materials")
        ->add_option("what", listed, "materials, radars or experiments")
        ->required()
        ->check(CLI::IsMember({"materials", "radars", "experiments"}));
    add_command(program, "show", "Explain a material, a radar, an experiment or any file",
                "specula show plexiglass; specula show out/paper/datasets/height.h5")
        ->add_option("what", shown, "a name (specula list), a .toml file or a .h5 dataset")
        ->required();
    add_command(program, "completion", "Print a completion script for a shell",
                "eval \"$(specula completion bash)\"")
        ->add_option("shell", shell, "bash or zsh")
        ->check(CLI::IsMember({"bash", "zsh"}))
        ->capture_default_str();

    try {
        program.parse(argc, argv);
        const std::string command = program.get_subcommands().front()->get_name();
        if (command == "completion") {
            std::vector<std::string> names;
            for (const CLI::App* each : program.get_subcommands({})) names.push_back(each->get_name());
            completion_command(shell, names);
            return 0;
        }
        const Catalogue catalogue = Catalogue::open(home_folder());
        if (command == "study") study_command(study, catalogue);
        if (command == "simulate") simulate_command(simulate, catalogue);
        if (command == "list") list_command(listed, catalogue);
        if (command == "show") show_command(shown, catalogue);
        return 0;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        say_error(std::string(error.what()) + "; see specula --help");
        return 2;
    } catch (const InputError& error) {
        say_error(error.what());
        return 2;
    } catch (const SystemError& error) {
        say_error(error.what());
        return 1;
    } catch (const std::bad_alloc&) {
        say_error("out of memory; run fewer worlds or sessions at once");
        return 1;
    } catch (const std::exception& error) {
        say_error(error.what());
        return 1;
    }
}

}  // namespace specula
