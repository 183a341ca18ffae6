#pragma once

#include <CLI/CLI.hpp>

#include "tools/specula/commands.hpp"

namespace specula {

/// The arguments of the commands about the firmware.
struct FirmwareArguments {
    ExportModelArguments export_model;
    VerifyRequest verify;
    LatencyArguments latency;
};

/// Adds `export model`, `verify-firmware` and `latency` to the program.
void add_firmware_commands(CLI::App& program, FirmwareArguments& arguments);

bool is_firmware_command(const std::string& command);

/// Runs the one that was parsed; returns the exit status.
int run_firmware_command(const CLI::App& program, const FirmwareArguments& arguments,
                         const Catalogue& catalogue);

}  // namespace specula
