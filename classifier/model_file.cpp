#include "classifier/model_file.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>

#include "classifier/json_field.hpp"
#include "classifier/model_fields.hpp"
#include "firmware/fw_mlp.h"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr const char* format_name = "specula model";
constexpr std::int64_t format_version = 2;  // 1 knew no convolution
constexpr std::uintmax_t max_bytes = 16u << 20;
constexpr std::size_t max_width = std::numeric_limits<std::uint16_t>::max();  // of fw_layer
constexpr std::size_t max_weights = 4u << 20;  // of a layer as the firmware would run it
constexpr std::size_t max_classes = 256;       // labels are bytes
constexpr std::string_view hdf5_start{"\x89HDF\r\n\x1a\n", 8};  ///< of every HDF5 file
constexpr float lowest = std::numeric_limits<float>::lowest();

FloatJson rows(const std::vector<float>& values, std::size_t n_in) {
    FloatJson result = FloatJson::array();
    for (auto row = values.begin(); row != values.end(); row += static_cast<std::ptrdiff_t>(n_in))
        result.push_back(std::vector<float>(row, row + static_cast<std::ptrdiff_t>(n_in)));
    return result;
}

/// Like dump(2), but an array of plain values stays on one line.
void print(const FloatJson& value, const std::string& indent, std::string& text) {
    const auto is_plain = [](const FloatJson& element) { return element.is_primitive(); };
    if (value.is_primitive() || (value.is_array() && std::ranges::all_of(value, is_plain))) {
        text += value.dump(-1, ' ', false, FloatJson::error_handler_t::replace);
        return;
    }
    const std::string inner = indent + "  ";
    text += value.is_array() ? "[" : "{";
    const char* separator = "\n";
    for (const auto& [key, element] : value.items()) {
        text += separator + inner;
        if (value.is_object())
            text += FloatJson(key).dump(-1, ' ', false, FloatJson::error_handler_t::replace) + ": ";
        print(element, inner, text);
        separator = ",\n";
    }
    text += "\n" + indent + (value.is_array() ? "]" : "}");
}

std::string read_text(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError(file.string() + ": no such file; check the path");
    if (!std::filesystem::is_regular_file(file, ignored))
        throw InputError(file.string() + ": is not a regular file; name a model file");
    std::ifstream in(file, std::ios::binary);
    char start[hdf5_start.size()] = {};
    if (in.read(start, sizeof start) && std::string_view(start, sizeof start) == hdf5_start)
        throw InputError(file.string() +
                         ": is a dataset (HDF5), not a model; a model (.json) belongs here");
    in.clear();
    in.seekg(0);
    if (std::filesystem::file_size(file, ignored) > max_bytes)
        throw InputError(file.string() + ": is larger than 16 MiB; name a model file");
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw InputError(file.string() + ": cannot be read; check its permissions");
    return text.str();
}

/// (out, in), with as many rows as there are, each of n_in numbers.
std::vector<float> read_rows(const JsonField& field, std::size_t n_in) {
    std::vector<float> values;
    const std::vector<JsonField> items = field.items();
    if (items.empty() || items.size() > max_width)
        field.fail("has no row or too many", format("use 1 to {}", max_width));
    for (const JsonField& row : items) {
        const std::vector<float> numbers = row.numbers(n_in, lowest);
        values.insert(values.end(), numbers.begin(), numbers.end());
    }
    return values;
}

/// Weights of one unit: all that comes in, or what a convolution sees of it.
std::size_t columns_of(const HiddenLayer& layer) {
    if (!layer.convolution) return layer.n_in;
    return layer.n_in / layer.convolution->n_positions * layer.convolution->kernel;
}

FloatJson hidden_json(const HiddenLayer& layer) {
    FloatJson json = FloatJson::object();
    if (layer.convolution) json["convolution"] = convolution_json(*layer.convolution);
    json["weight"] = rows(layer.weight, columns_of(layer));
    if (!layer.bias.empty()) json["bias"] = layer.bias;
    if (!layer.gamma.empty())
        json.update(batch_norm_json({layer.gamma, layer.beta, layer.mean, layer.variance}));
    if (layer.after_relu) json["after_relu"] = batch_norm_json(*layer.after_relu);
    return json;
}

HiddenLayer read_hidden(const JsonField& field, std::size_t n_in) {
    HiddenLayer layer;
    layer.n_in = n_in;
    if (field.has("convolution"))
        layer.convolution = read_convolution(field.at("convolution"), n_in);
    layer.weight = read_rows(field.at("weight"), columns_of(layer));
    const std::size_t n_units = layer.weight.size() / columns_of(layer);
    layer.n_out = n_units * (layer.convolution ? layer.convolution->n_positions : 1);
    if (layer.n_out > max_width || layer.n_in * layer.n_out > max_weights)
        field.at("weight").fail("makes a layer too wide", "use fewer units or channels");
    if (field.has("bias")) layer.bias = field.at("bias").numbers(n_units, lowest);
    if (field.has("after_relu"))
        layer.after_relu = read_batch_norm(field.at("after_relu"), n_units);
    if (!field.has("gamma") && field.has("after_relu")) return layer;
    const BatchNorm before = read_batch_norm(field, n_units);
    layer.gamma = before.gamma;
    layer.beta = before.beta;
    layer.mean = before.mean;
    layer.variance = before.variance;
    return layer;
}

std::vector<std::string> read_class_names(const JsonField& field) {
    std::vector<std::string> names;
    for (const JsonField& item : field.items()) names.push_back(item.text());
    if (names.empty() || names.size() > max_classes)
        field.fail("has no class or too many", format("use 1 to {}", max_classes));
    if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
        field.fail("names a class twice", "give each its own name");
    return names;
}

std::vector<std::string> read_feature_names(const JsonField& field, std::size_t n_features) {
    std::vector<std::string> names;
    for (const JsonField& item : field.items()) names.push_back(item.text());
    if (names.size() != n_features)
        field.fail("has the wrong length", format("one per feature: {}", n_features));
    return names;
}

Model read_fields(const JsonField& root) {
    if (root.at("format").text() != format_name)
        root.at("format").fail("is another kind of file", "name a model file");
    const std::int64_t version = root.at("version").integer();
    if (version < 1 || version > format_version)
        root.at("version").fail("is not a version this program reads",
                                format("use a model of version {} or before", format_version));
    Model model;
    model.extractor = root.at("extractor").text();
    model.class_names = read_class_names(root.at("class_names"));
    for (const JsonField& item : root.at("provenance").items())
        model.provenance.emplace_back(item.key(), item.text());
    const JsonField mean = root.at("input_mean");
    std::size_t n_in = mean.items().size();
    if (n_in == 0 || n_in > max_width)
        mean.fail("has no feature or too many", format("use 1 to {}", max_width));
    model.input_mean = mean.numbers(n_in, lowest);
    model.input_scale = root.at("input_scale").numbers(n_in, 0.0f);
    if (root.has("input_norm")) model.input_norm = read_batch_norm(root.at("input_norm"), n_in);
    if (root.has("measurement")) model.measurement = read_measurement(root.at("measurement"));
    if (root.has("feature_names"))
        model.feature_names = read_feature_names(root.at("feature_names"), n_in);
    if (root.has("prototypes"))
        model.prototypes = read_prototypes(root.at("prototypes"), n_in);
    if (root.has("monitor"))
        model.monitor = read_monitor(root.at("monitor"), {n_in, model.n_classes()});
    const std::vector<JsonField> hidden = root.at("hidden").items();
    if (hidden.size() + 1 > FW_MLP_MAX_LAYERS)
        root.at("hidden").fail("has too many layers",
                               format("the firmware runs at most {}", FW_MLP_MAX_LAYERS - 1));
    for (const JsonField& layer : hidden) {
        model.hidden.push_back(read_hidden(layer, n_in));
        n_in = model.hidden.back().n_out;
    }
    const JsonField output = root.at("output");
    model.output = {.n_in = n_in,
                    .n_out = model.n_classes(),
                    .weight = read_rows(output.at("weight"), n_in),
                    .bias = output.at("bias").numbers(model.n_classes(), lowest)};
    if (model.output.weight.size() != n_in * model.n_classes())
        output.at("weight").fail("has the wrong number of rows",
                                 format("one per class: {}", model.n_classes()));
    return model;
}

}  // namespace

void write_model(const Model& model, const std::filesystem::path& file) {
    FloatJson root;
    root["format"] = format_name;
    const auto convolves = [](const HiddenLayer& layer) { return layer.convolution.has_value(); };
    root["version"] = std::ranges::any_of(model.hidden, convolves) ? format_version : 1;
    root["extractor"] = model.extractor;
    root["class_names"] = model.class_names;
    if (!model.feature_names.empty()) root["feature_names"] = model.feature_names;
    root["provenance"] = FloatJson::object();
    for (const auto& [what, value] : model.provenance) root["provenance"][what] = value;
    root["input_mean"] = model.input_mean;
    root["input_scale"] = model.input_scale;
    if (model.input_norm) root["input_norm"] = batch_norm_json(*model.input_norm);
    if (model.measurement) root["measurement"] = measurement_json(*model.measurement);
    if (model.monitor) root["monitor"] = monitor_json(*model.monitor);
    if (model.prototypes) root["prototypes"] = prototypes_json(*model.prototypes);
    root["hidden"] = FloatJson::array();
    for (const HiddenLayer& layer : model.hidden) root["hidden"].push_back(hidden_json(layer));
    root["output"] = {{"weight", rows(model.output.weight, model.output.n_in)},
                      {"bias", model.output.bias}};
    std::string text;
    print(root, "", text);
    write_file_atomically(file, text + "\n");
}

Model read_model(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::string text = read_text(file);
    try {
        const FloatJson root = FloatJson::parse(text);
        return read_fields(JsonField(name, root));
    } catch (const FloatJson::parse_error& error) {
        const std::size_t place = std::min<std::size_t>(error.byte, text.size());
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
        throw InputError(
            format("{}: is not valid JSON in line {}; name a model that train or study wrote", name,
                   1 + std::count(text.begin(), end, '\n')));
    } catch (const FloatJson::exception&) {
        throw InputError(format(
            "{}: is not valid JSON, or holds a number beyond float; train the model again", name));
    }
}

}  // namespace specula
