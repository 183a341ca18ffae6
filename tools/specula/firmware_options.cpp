#include "tools/specula/firmware_options.hpp"

#include "sim/parallel.hpp"
#include "tools/specula/command_options.hpp"

namespace specula {

namespace {

void add_export(CLI::App& program, ExportModelArguments& arguments) {
    CLI::App* model = export_group(program)->add_subcommand(
        "model", "Write a trained model as the firmware's blob, as C, or as ONNX");
    model->footer(
        "Example:\n  specula export model out/paper/models/world_000.json --arithmetic int16 \\\n"
        "      --blob model.rfwm --c bench.c --onnx model.onnx\n"
        "  bench.c then holds fw_model_bench[] and fw_model_bench_bytes for fw_model_open.");
    model
        ->add_option("MODEL", arguments.model,
                     "of specula study (models/world_000.json) or specula train")
        ->required();
    model->add_option("--blob", arguments.blob, "the bytes fw_model_open takes")->type_name("FILE");
    model->add_option("--c", arguments.c_source, "the same bytes as a C array")->type_name("FILE");
    model
        ->add_option("--symbol", arguments.symbol,
                     "name of the C array; default fw_model_ and the C file's name")
        ->type_name("NAME");
    model->add_option("--onnx", arguments.onnx, "the folded network in float32, operator set 13")
        ->type_name("FILE");
    model
        ->add_option("--arithmetic", arguments.arithmetic,
                     "of the blob: float, int16 or int8; ONNX is always float")
        ->check(CLI::IsMember({"float", "int16", "int8"}).description(""))
        ->capture_default_str();
}

void add_verify(CLI::App& program, VerifyRequest& request) {
    CLI::App* command = add_command(
        program, "verify-firmware",
        "Compare the firmware's builds bit for bit, and say what it costs on the chip",
        "specula verify-firmware out/paper/datasets/training.h5 "
        "out/paper/models/world_000.json\n"
        "  Needs gcc-arm-none-eabi, libnewlib-arm-none-eabi and qemu-system-arm. Exit status: 1 "
        "where\n  builds differ or a budget of firmware/budget.toml is exceeded. About 30 s.");
    command->add_option("DATASET", request.dataset,
                        "frames: a .h5 dataset or a .bin of ADC injection; default: simulated");
    command->add_option("MODEL", request.model,
                        "a model of a study; default: one trained on the frames");
    command
        ->add_option("--descriptor", request.descriptor,
                     "of the model trained here, e.g. \"peak_shape 6 12 blackman align 11.5 range "
                     "11.5 search 4 20\" (classifier/README.md); default: the paper's range bins")
        ->type_name("LINE");
    command
        ->add_option("--hidden", request.hidden,
                     "units of its hidden layers, e.g. 32,32; default 16,16")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024).description(""));
    command->add_option("--frames", request.most_frames, "at most so many, evenly over all")
        ->check(CLI::Range(2, 100000).description(""))
        ->capture_default_str();
    add_threads(command, request.threads);
}

void add_latency(CLI::App& program, LatencyArguments& arguments) {
    arguments.experiment = "paper";
    arguments.out = "out/latency";
    CLI::App* command = add_command(
        program, "latency",
        "Table and figure of accuracy against time on the chip, by network size",
        "specula latency paper --worlds 8 --threads 2 --out /tmp/latency\n"
        "  Trains 8 sizes in every world, quantises them, counts their instructions in QEMU. "
        "Writes\n"
        "  latency.svg, latency.png and latency.csv. About a minute.");
    command
        ->add_option("EXPERIMENT", arguments.experiment,
                     "a name (specula list experiments) or a .toml file")
        ->capture_default_str();
    command->add_option("-o,--out", arguments.out, "folder to write")
        ->type_name("FOLDER")
        ->capture_default_str();
    command
        ->add_option("--descriptor", arguments.descriptor,
                     "what the networks see, e.g. \"peak_shape 6 12 blackman align 11.5 range 11.5 "
                     "search 4 20\" (classifier/README.md); default: the experiment's range bins")
        ->type_name("LINE");
    command->add_option("--worlds", arguments.worlds, "to train and judge in, 1 to 1000")
        ->check(CLI::Range(1, 1000).description(""))
        ->capture_default_str();
    add_threads(command, arguments.threads);
}

}  // namespace

void add_firmware_commands(CLI::App& program, FirmwareArguments& arguments) {
    add_export(program, arguments.export_model);
    arguments.latency.threads = arguments.verify.threads = available_threads();
    add_verify(program, arguments.verify);
    add_latency(program, arguments.latency);
}

bool is_firmware_command(const std::string& command) {
    return command == "export" || command == "verify-firmware" || command == "latency";
}

int run_firmware_command(const CLI::App& program, const FirmwareArguments& arguments,
                         const Catalogue& catalogue) {
    const std::string command = program.get_subcommands().front()->get_name();
    if (command == "verify-firmware") return verify_firmware_command(arguments.verify, catalogue);
    if (command == "latency") latency_command(arguments.latency, catalogue);
    if (command == "export") export_model_command(arguments.export_model);
    return 0;
}

}  // namespace specula
