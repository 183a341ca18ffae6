#include "classifier/export_onnx.hpp"

#include <span>
#include <string>

#include "classifier/folded_model.hpp"
#include "firmware/fw_bytes.h"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"

namespace specula {

namespace {

/// A protocol-buffers message, field after field; the numbers are those of onnx.proto.
class Message {
  public:
    Message& integer(unsigned field, std::uint64_t value) {
        varint(field << 3 | 0);
        varint(value);
        return *this;
    }
    Message& text(unsigned field, const std::string& value) {
        varint(field << 3 | 2);
        varint(value.size());
        bytes_ += value;
        return *this;
    }
    Message& message(unsigned field, const Message& value) { return text(field, value.bytes_); }
    const std::string& bytes() const { return bytes_; }

  private:
    void varint(std::uint64_t value) {
        for (; value >= 128; value >>= 7) bytes_ += static_cast<char>((value & 127) | 128);
        bytes_ += static_cast<char>(value);
    }
    std::string bytes_;
};

constexpr std::uint64_t float_type = 1;    // TensorProto.FLOAT
constexpr std::uint64_t integer_kind = 2;  // AttributeProto.INT

Message attribute(const std::string& name, std::uint64_t value) {
    return Message().text(1, name).integer(3, value).integer(20, integer_kind);
}

struct Operator {
    std::string type;
    std::vector<std::string> inputs;
    std::string output;
    std::vector<Message> attributes{};
};

Message node(const Operator& op) {
    Message message;
    for (const std::string& input : op.inputs) message.text(1, input);
    message.text(2, op.output).text(3, op.output + "_" + op.type).text(4, op.type);
    for (const Message& each : op.attributes) message.message(5, each);
    return message;
}

Message tensor(const std::string& name, const std::vector<std::size_t>& dims,
               std::span<const float> values) {
    Message message;
    for (const std::size_t dim : dims) message.integer(1, dim);
    std::string raw(4 * values.size(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
        fw_write_f32(reinterpret_cast<std::uint8_t*>(raw.data()) + 4 * i, values[i]);
    return message.integer(2, float_type).text(8, name).text(9, raw);
}

/// A matrix of floats with as many rows as there are examples.
Message value_info(const std::string& name, std::size_t n_columns) {
    const Message shape =
        Message().message(1, Message().text(2, "N")).message(1, Message().integer(1, n_columns));
    const Message type = Message().message(1, Message().integer(1, float_type).message(2, shape));
    return Message().text(1, name).message(2, type);
}

Message graph_of(const Model& model) {
    const FoldedModel folded = fold(model);
    const std::size_t n_features = model.n_features();
    Message graph;
    std::vector<Message> initializers{tensor("input_mean", {n_features}, folded.input_mean),
                                      tensor("input_scale", {n_features}, folded.input_scale)};
    graph.message(1, node({"Sub", {"features", "input_mean"}, "centred"}));
    graph.message(1, node({"Mul", {"centred", "input_scale"}, "values_0"}));
    for (std::size_t l = 0; l < folded.layers.size(); ++l) {
        const AffineLayer<float>& layer = folded.layers[l];
        const bool is_last = l + 1 == folded.layers.size();
        const std::string weight = format("weight_{}", l), bias = format("bias_{}", l);
        const std::string sum = is_last ? "logits" : format("sum_{}", l);
        initializers.push_back(tensor(weight, {layer.n_out, layer.n_in}, layer.weight));
        initializers.push_back(tensor(bias, {layer.n_out}, layer.bias));
        graph.message(
            1,
            node({"Gemm", {format("values_{}", l), weight, bias}, sum, {attribute("transB", 1)}}));
        if (!is_last) graph.message(1, node({"Relu", {sum}, format("values_{}", l + 1)}));
    }
    graph.message(1, node({"Softmax", {"logits"}, "probabilities", {attribute("axis", 1)}}));
    graph.text(2, "specula_classifier");
    for (const Message& initializer : initializers) graph.message(5, initializer);
    graph.message(11, value_info("features", n_features));
    graph.message(12, value_info("logits", model.n_classes()));
    graph.message(12, value_info("probabilities", model.n_classes()));
    return graph;
}

Message metadata(const std::string& key, const std::string& value) {
    return Message().text(1, key).text(2, value);
}

}  // namespace

std::vector<std::uint8_t> export_onnx(const Model& model) {
    Message file;
    file.integer(1, 7).text(2, "specula").text(3, program_version).message(7, graph_of(model));
    file.message(8, Message().text(1, "").integer(2, 13));
    file.message(14, metadata("extractor", model.extractor));
    for (std::size_t c = 0; c < model.class_names.size(); ++c)
        file.message(14, metadata(format("class_{}", c), model.class_names[c]));
    for (const auto& [what, value] : model.provenance) file.message(14, metadata(what, value));
    return {file.bytes().begin(), file.bytes().end()};
}

}  // namespace specula
