#include <cstdio>

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
    for (const auto& out : {arguments.blob, arguments.c_source, arguments.onnx})
        if (!out.empty()) prepare_output(out, {arguments.model});
    const Model model = read_model(arguments.model);
    // Everything is made before anything is written.
    std::vector<std::uint8_t> blob;
    std::string c_source;
    if (!arguments.blob.empty() || !arguments.c_source.empty())
        blob = made_from(arguments,
                         [&] { return model_blob(model, arithmetic_of(arguments.arithmetic)); });
    if (!arguments.c_source.empty()) c_source = blob_as_c(blob, "fw_model_blob");
    const std::vector<std::uint8_t> onnx =
        arguments.onnx.empty() ? std::vector<std::uint8_t>{} : export_onnx(model);

    if (!arguments.blob.empty()) write(arguments.blob, text_of(blob));
    if (!arguments.c_source.empty()) write(arguments.c_source, c_source);
    if (!arguments.onnx.empty()) write(arguments.onnx, text_of(onnx));
}

}  // namespace specula
