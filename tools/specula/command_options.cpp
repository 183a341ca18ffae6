#include "tools/specula/command_options.hpp"

#include <charconv>

#include "sim/core/format.hpp"

namespace specula {

CLI::App* add_command(CLI::App& program, const char* name, const char* what, const char* example) {
    CLI::App* command = program.add_subcommand(name, what);
    command->footer(std::string("Example:\n  ") + example);
    return command;
}

void add_threads(CLI::App* command, int& threads) {
    command
        ->add_option("-j,--threads", threads,
                     "1 to 1024; results do not depend on it; default all processors")
        ->check(CLI::Range(1, 1024).description(""))
        ->capture_default_str();
}

CLI::Validator number_within(double low, double high) {
    return CLI::Validator(
        [=](std::string& text) {
            double value = 0.0;
            if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high)
                return std::string();
            return format("Value {} not in range [{:g} - {:g}]", text, low, high);
        },
        "");
}

std::string seed_problem(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error == std::errc{} && end == text.data() + text.size()) return "";
    return text + " is not a whole number from 0 to 18446744073709551615";
}

void add_bench(CLI::App& program, BenchArguments& arguments) {
    CLI::App* command = add_command(
        program, "bench", "Measure how fast this machine simulates, beside what limits it",
        "specula bench stages channel --seconds 1\n"
        "  WHAT: generate, stages, trace, channel, receiver, frames, storage, learning, growth,\n"
        "  threads.\n"
        "  Rates are per second of CPU time of one core; all of them take half a minute.");
    command->add_option("WHAT", arguments.parts, "parts to measure; default all");
    command->add_option("--seconds", arguments.seconds, "s of CPU time per rate, 0.001 to 60")
        ->check(number_within(0.001, 60.0))
        ->capture_default_str();
    command->add_option("--decades", arguments.decades, "of size in growth, 0.5 to 3")
        ->check(number_within(0.5, 3.0))
        ->capture_default_str();
    command->add_flag("--json", arguments.json, "print JSON instead of tables");
    command->add_option("--figure", arguments.figure, "draw stages and growth as SVG, PNG and CSV")
        ->type_name("FOLDER");
    add_threads(command, arguments.threads);
}

void add_import(CLI::App& program, ImportArguments& arguments) {
    CLI::App* command = add_command(
        program, "import", "Read a recording into a dataset",
        "specula import uart session.bin --manifest session.toml -o session.h5\n"
        "  FORMAT: adc (flat int16), dca1000, rdif (swizzle mode 2), injection (TI), uart (TI\n"
        "  TLVs), infineon (a folder of radar.npy and config.json), npy, npz or csv.\n"
        "  What a file does not say stands in a manifest: sim/dataset/FORMAT.md has its keys.");
    command
        ->add_option("WHAT", arguments.what,
                     "[FORMAT] INPUT; a folder, .npy, .npz and .csv need no FORMAT")
        ->required()
        ->expected(1, 2);
    command
        ->add_option("--manifest", arguments.manifest,
                     "labels and layout (.toml); default INPUT.toml where there is one")
        ->type_name("FILE");
    command->add_option("-o,--out", arguments.out, "dataset to write; default INPUT.h5 here")
        ->type_name("FILE");
}

CLI::App* export_group(CLI::App& program) {
    const auto is_export = [](CLI::App* app) { return app->get_name() == "export"; };
    if (const auto found = program.get_subcommands(is_export); !found.empty()) return found[0];
    CLI::App* group = add_command(
        program, "export",
        "Write a model or a dataset in the form that a chip, a sensor or another program takes",
        "specula export model out/paper/models/world_000.json --blob model.rfwm\n"
        "  specula export injection out/paper/datasets/height.h5 -o adc.bin");
    group->require_subcommand(1);
    return group;
}

/// What `specula import` makes of an exported file, behind "reads it back".
const char* what_comes_back(const std::string& format_name) {
    if (format_name == "csv")
        return ": classes, groups and features, which for codes are range bins";
    if (format_name == "uart")
        return ": range profiles and answers; labels stand in plate.out.toml";
    return ", bit by bit; labels stand in plate.out.toml";
}

void add_export_recording(CLI::App& program, ExportRecordingArguments& arguments) {
    CLI::App* group = export_group(program);
    for (const auto& [name, what] : std::vector<std::pair<std::string, const char*>>{
             {"adc", "Codes as flat int16 in the order frame, chirp, rx, sample"},
             {"dca1000", "Codes as a capture card stores them"},
             {"rdif", "12-bit codes as the IWRL6432 sends them over RDIF, swizzle mode 2"},
             {"injection", "Codes for TI's demo to read instead of its ADC (adcDataSource)"},
             {"uart", "Range profiles in the firmware's counts (TLV 302), with answers (TLV 1031)"},
             {"infineon", "Codes as a folder of radar.npy and config.json"},
             {"npy", "Codes, or features where there are none, as NumPy's array"},
             {"csv", "Features and labels as a table"}}) {
        CLI::App* command = group->add_subcommand(name, what);
        command->footer(
            format("Example:\n  specula export {0} plate.h5 -o plate.out\n"
                   "  specula import {0} plate.out reads it back{1}.",
                   name, what_comes_back(name)));
        command->callback([&arguments, name = name] { arguments.what = name; });
        command->add_option("DATASET", arguments.input, "dataset (.h5)")->required();
        command->add_option("-o,--out", arguments.out, "file or (infineon) folder to write")
            ->required()
            ->type_name("FILE");
        if (name == "uart")
            command
                ->add_option("--model", arguments.model,
                             "whose answers go along (TLV 1031); profiles then pass its window")
                ->type_name("FILE");
        if (name == "infineon")
            command
                ->add_option("--radar", arguments.radar,
                             "whose frequencies config.json names; default the dataset's")
                ->type_name("NAME");
    }
}

}  // namespace specula
