#include "tools/firmware/verify_report.hpp"

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double clock_hz = 160e6;

std::string shape_of(const Model& model) {
    std::string text = format("{}", model.n_features());
    for (const HiddenLayer& layer : model.hidden) text += format("-{}", layer.n_out);
    return text + format("-{}", model.n_classes());
}

std::string mismatch_row(const std::string& name, const VariantResult& result,
                         const Mismatches& found) {
    return format("  {:<28}{:>8}{:>10}{:>9}{:>15}{:>10}{:>12}\n", name, result.n_frames,
                  found.features, found.logits, found.probabilities, found.rest, found.uart_bytes);
}

std::string comparison_table(const Verification& verification) {
    const std::string head =
        format("  {:<28}{:>8}{:>10}{:>9}{:>15}{:>10}{:>12}\n", "", "frames", "features", "logits",
               "probabilities", "the rest", "UART bytes");
    std::string text = "Mismatches, host build against emulated Cortex-M4F (bit for bit):\n" + head;
    for (const VariantResult& result : verification.variants)
        text += mismatch_row(result.variant.name, result, result.host_target);
    text += "Mismatches, host build against the library inside this program:\n" + head;
    for (const VariantResult& result : verification.variants)
        text += mismatch_row(result.variant.name, result, result.host_library);
    std::size_t uart = 0;
    for (const VariantResult& result : verification.variants) uart += result.n_uart_bytes;
    return text + format("  {} UART bytes in all; the self-test passed on both machines\n", uart);
}

std::string flag_table(const Verification& verification) {
    std::string text = format(
        "Frames the firmware warned of:\n  {:<28}{:>8}{:>9}{:>11}{:>11}{:>10}{:>9}{:>12}\n", "",
        "frames", "refused", "saturated", "dead rows", "cut bins", "clipped", "suspicious");
    for (const VariantResult& result : verification.variants) {
        const FrameFlags& flags = result.flags;
        text += format("  {:<28}{:>8}{:>9}{:>11}{:>11}{:>10}{:>9}{:>12}\n", result.variant.name,
                       result.n_frames, flags.refused, flags.saturated, flags.dead, flags.cut_bins,
                       flags.clipped_inputs, flags.suspicious);
    }
    return text +
           "  saturated: samples at a limit of the converter; cut bins: beyond the HWA-like\n"
           "  transform's integers; clipped: inputs beyond the reach of an integer network;\n"
           "  suspicious: any of these, or unlike the rows the model was trained on.\n";
}

std::string stage_row(const std::string& stage, const StageCost& cost) {
    const double us = 1e6 / clock_hz;
    return format("  {:<28}{:>14.0f}{:>10.0f} to {:<8.0f}{:>9.1f} to {:<7.1f}\n", stage,
                  cost.instructions, cost.cycles.low, cost.cycles.high, us * cost.cycles.low,
                  us * cost.cycles.high);
}

std::string stage_table(const Verification& verification) {
    std::string text = format("Cost on the Cortex-M4F, per frame:\n  {:<28}{:>14}{:>20}{:>21}\n",
                              "", "instructions", "cycles, estimated", "us at 160 MHz, est.");
    for (const auto& [stage, cost] : verification.stages.at("float32"))
        text += stage_row(stage == "network" ? "network, float32" : stage, cost);
    for (const char* arithmetic : {"int16", "int8"})
        text += stage_row(format("network, {}", arithmetic),
                          verification.stages.at(arithmetic).at("network"));
    return text +
           "  Instructions are counted by QEMU, on the first frame; hwa_fft and the integer\n"
           "  networks branch on the data, and take a few in a thousand more or less on others.\n"
           "  Cycles and times are an ESTIMATE: the executed instructions, priced between the "
           "best\n"
           "  and the worst case of Arm's Cortex-M4 manual, without wait states; never measured "
           "on\n"
           "  the chip, which has no cycle counter.\n"
           "  hwa_fft is done by the accelerator on the chip and emulated on the processor here.\n";
}

std::string size_table(const Verification& verification) {
    std::string text =
        format("Bytes of the library, from the linker's map:\n  {:<28}{:>8}{:>11}{:>7}\n", "",
               "code", "constants", "RAM");
    ModuleSize sum;
    for (const auto& [name, size] : verification.modules) {
        text += format("  {:<28}{:>8}{:>11}{:>7}\n", name, size.code, size.constants, size.ram);
        sum.code += size.code;
        sum.constants += size.constants;
        sum.ram += size.ram;
    }
    text += format("  {:<28}{:>8}{:>11}{:>7}\n", "together", sum.code, sum.constants, sum.ram);
    text += format("  model blob {}, scratch of fw_classify {}; from a C library:",
                   verification.model_bytes, verification.scratch_bytes);
    for (const std::string& symbol : verification.foreign) text += " " + symbol;
    return text + "\n";
}

std::string path_of(const StackDepth& depth) {
    std::string text;
    for (const std::string& function : depth.path)
        text += (text.empty() ? "" : " > ") + function.substr(function.rfind(':') + 1);
    return text;
}

std::string stack_table(const Verification& verification) {
    std::string text =
        "Deepest stack below each function, bytes, from the compiler's frames and calls:\n";
    for (const StackDepth& depth : verification.stacks)
        text += format("  {:>6}  {}\n", depth.bytes, path_of(depth));
    return text +
           "  Nothing recurses. memcpy, memset and memcmp count 0; an interrupt takes up to 104\n"
           "  bytes more.\n";
}

}  // namespace

std::string verify_report(const VerifyInput& input, const Verification& verification) {
    return format("{} frames of {} x {} x {} (chirps, antennas, samples), {}\nnetwork {}, {}\n\n",
                  input.frames.n_frames(), input.frames.n_chirps, input.frames.n_rx,
                  input.frames.n_samples, input.frames_are, shape_of(input.model), input.model_is) +
           comparison_table(verification) + "\n" + flag_table(verification) + "\n" +
           stage_table(verification) + "\n" + size_table(verification) + "\n" +
           stack_table(verification);
}

}  // namespace specula
