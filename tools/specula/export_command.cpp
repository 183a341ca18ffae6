#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "classifier/export_c.hpp"
#include "classifier/export_onnx.hpp"
#include "classifier/model_blob.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/output_place.hpp"

namespace specula {

namespace {

fw_arithmetic arithmetic_of(const std::string& name) {
    return name == "int8"    ? FW_ARITHMETIC_INT8
           : name == "int16" ? FW_ARITHMETIC_INT16
                             : FW_ARITHMETIC_FLOAT;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

void write(const std::filesystem::path& file, const std::string& content) {
    write_file_atomically(file, content);
    std::printf("wrote %s, %zu bytes\n", file.c_str(), content.size());
}

using Output = std::pair<const char*, std::filesystem::path>;  // (option, file)

std::array<Output, 3> outputs_of(const ExportModelArguments& arguments) {
    return {Output{"--blob", arguments.blob}, Output{"--c", arguments.c_source},
            Output{"--onnx", arguments.onnx}};
}

/// An option that changes nothing in what is written would be thought to have done so.
void check_heeded(const ExportModelArguments& arguments) {
    if (!arguments.symbol.empty() && arguments.c_source.empty())
        throw InputError("--symbol: goes with --c, whose array it names; add --c FILE");
    if (arguments.arithmetic != "float" && arguments.blob.empty() && arguments.c_source.empty())
        throw InputError(
            "--arithmetic: goes with --blob or --c, and ONNX is always float; leave it out");
}

/// Each output must have a file of its own: the second would replace the first.
void check_files_differ(const ExportModelArguments& arguments) {
    std::map<std::filesystem::path, const char*> taken;
    for (const auto& [option, file] : outputs_of(arguments)) {
        if (file.empty()) continue;
        const auto [found, is_new] = taken.emplace(
            std::filesystem::weakly_canonical(std::filesystem::absolute(file)), option);
        if (!is_new)
            throw InputError(format("{} = {}: is the file of {} too; give each a file of its own",
                                    option, file.string(), found->second));
    }
}

/// The name of the array: two models in one program need two.
std::string symbol_of(const ExportModelArguments& arguments) {
    if (!arguments.symbol.empty()) return arguments.symbol;
    constexpr std::size_t longest = 32;  // check_c_name
    std::string name = "fw_model_";
    for (const char c : arguments.c_source.stem().string()) {
        const bool is_upper = c >= 'A' && c <= 'Z';
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        name += is_upper ? static_cast<char>(c - 'A' + 'a') : is_plain ? c : '_';
    }
    return name.substr(0, longest);
}

/// What can go wrong is in the model: the message then begins with its file.
template <typename Make>
auto made_from(const ExportModelArguments& arguments, Make make) {
    try {
        return make();
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.model.string(), error.what()));
    }
}

}  // namespace

void export_model_command(const ExportModelArguments& arguments) {
    if (arguments.blob.empty() && arguments.c_source.empty() && arguments.onnx.empty())
        throw InputError("export model: nothing to write; give --blob, --c or --onnx with a file");
    check_heeded(arguments);
    for (const auto& [option, out] : outputs_of(arguments))
        if (!out.empty()) prepare_output(out, {arguments.model}, option);
    check_files_differ(arguments);
    if (!arguments.symbol.empty()) check_c_name(arguments.symbol);
    const Model model = read_model(arguments.model);
    // Everything is made before anything is written.
    std::vector<std::uint8_t> blob;
    std::string c_source;
    if (!arguments.blob.empty() || !arguments.c_source.empty())
        blob = made_from(arguments,
                         [&] { return model_blob(model, arithmetic_of(arguments.arithmetic)); });
    if (!arguments.c_source.empty()) c_source = blob_as_c(blob, symbol_of(arguments));
    const std::vector<std::uint8_t> onnx =
        arguments.onnx.empty() ? std::vector<std::uint8_t>{} : export_onnx(model);

    if (!arguments.blob.empty()) write(arguments.blob, text_of(blob));
    if (!arguments.c_source.empty()) write(arguments.c_source, c_source);
    if (!arguments.onnx.empty()) write(arguments.onnx, text_of(onnx));
}

}  // namespace specula
