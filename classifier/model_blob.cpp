#include "classifier/model_blob.hpp"

#include <cstring>
#include <limits>

#include "classifier/descriptor.hpp"
#include "classifier/export_c.hpp"
#include "classifier/folded_model.hpp"
#include "classifier/integer_model.hpp"
#include "classifier/peak_shape.hpp"
#include "firmware/fw_bytes.h"
#include "firmware/fw_crc32.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t start_bytes = 16;  // magic, version, reserved, length, CRC
constexpr std::uint16_t version_of_range_bins = 1, version_with_kinds = 2;

/// Bytes that grow, little-endian.
class BlobWriter {
  public:
    void u16(std::uint16_t value) {
        bytes_.resize(bytes_.size() + 2);
        fw_write_u16(bytes_.data() + bytes_.size() - 2, value);
    }
    void u32(std::uint32_t value) {
        bytes_.resize(bytes_.size() + 4);
        fw_write_u32(bytes_.data() + bytes_.size() - 4, value);
    }
    void f32(float value) {
        bytes_.resize(bytes_.size() + 4);
        fw_write_f32(bytes_.data() + bytes_.size() - 4, value);
    }
    void floats(const std::vector<float>& values) {
        for (const float value : values) f32(value);
    }
    void words(const std::vector<std::int32_t>& values) {
        for (const std::int32_t value : values) u32(static_cast<std::uint32_t>(value));
    }
    void name(const std::string& text) {
        for (std::size_t i = 0; i < FW_MODEL_NAME_BYTES; ++i)
            bytes_.push_back(i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0);
    }
    void byte(std::int8_t value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
    void pad() { bytes_.resize((bytes_.size() + 3) / 4 * 4); }
    std::vector<std::uint8_t>& bytes() { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
};

/// What a model was trained on, as far as it says.
std::string description_of(const Model& model) {
    for (const auto& [what, value] : model.provenance)
        if (what == "descriptor") return value;
    return model.extractor;
}

bool is_peak_shape(const Descriptor& descriptor) {
    return descriptor.extractor == "peak_shape";
}

void check_descriptor(const Descriptor& descriptor, const fw_extract_config& measured) {
    if (descriptor.extractor == "relative_profile")
        throw InputError(
            format("descriptor = \"{}\": the firmware does not compute it; train on peak_shape, "
                   "its form for the chip, or export the network alone as --onnx",
                   descriptor.text()));
    if (descriptor.unit_energy || descriptor.angle_rx > 0 || descriptor.looks > 1)
        throw InputError(
            format("descriptor = \"{}\": the firmware does not compute it; train on range_bins "
                   "with align, range and log, or export the network alone as --onnx",
                   descriptor.text()));
    if (is_peak_shape(descriptor) &&
        (measured.integration != FW_INTEGRATE_MEAN || measured.path != FW_RANGE_FLOAT))
        throw InputError(
            "measurement: a peak_shape is the mean over all rows, in float; use "
            "integration = \"mean\" and range_fft = \"float\"");
}

void check(const Model& model) {
    if (!model.measurement)
        throw InputError(
            format("measurement: is missing, and the firmware refuses to run a model that does not "
                   "say which chirp and range bins it was trained on (here: {}); train on range "
                   "bins of a dataset whose radar the catalogue knows (specula show DATASET; an "
                   "import takes radar = \"NAME\" from its manifest) or with --radar NAME, take a "
                   "model of specula "
                   "study, or export it as --onnx",
                   description_of(model)));
    check_descriptor(descriptor_of(model), model.measurement->descriptor);
    if (model.n_features() > FW_MODEL_MAX_FEATURES)
        throw InputError(
            format("input_mean = [{} values]: more features than the firmware takes; "
                   "use at most {}",
                   model.n_features(), FW_MODEL_MAX_FEATURES));
    if (model.n_classes() > FW_MODEL_MAX_CLASSES)
        throw InputError(
            format("class_names = [{} values]: more classes than the firmware takes; "
                   "use at most {}",
                   model.n_classes(), FW_MODEL_MAX_CLASSES));
    for (const std::string& name : model.class_names)
        if (name.empty() || name.size() >= FW_MODEL_NAME_BYTES ||
            name.find('\0') != std::string::npos)
            throw InputError(
                format("class_names = \"{}\": does not fit the firmware; use 1 to {} "
                       "bytes",
                       name, FW_MODEL_NAME_BYTES - 1));
    const std::size_t n_bins = model.measurement->descriptor.n_bins;
    if ((is_peak_shape(descriptor_of(model)) ? 2 * n_bins + 1 : n_bins) != model.n_features())
        throw InputError(
            format("measurement.n_bins = {}: but the model takes {} features; train "
                   "it again",
                   n_bins, model.n_features()));
}

void write_chirp(const fw_chirp& chirp, BlobWriter& out) {
    out.u32(chirp.start_khz);
    out.u32(static_cast<std::uint32_t>(chirp.slope_khz_us));
    out.u32(chirp.sample_rate_hz);
    for (const std::uint16_t value :
         {chirp.n_samples, chirp.skip_samples, chirp.n_rx, chirp.n_chirps, chirp.high_pass_hz_10,
          static_cast<std::uint16_t>(chirp.gain_db_100), chirp.adc_bits})
        out.u16(value);
}

/// fw_relative's own numbers, in the fields of those of range bins; no step of normalisation.
void write_shape(const Descriptor& descriptor, BlobWriter& out) {
    const fw_relative_config shape = shape_config(descriptor);
    out.u16(0);
    out.f32(shape.target_bin);
    out.f32(shape.floor_lsb);
    out.u16(shape.search_first);
    out.u16(shape.n_search);
}

/// Numbers that no step uses are 0, and then the peak is looked for nowhere but in the descriptor.
void write_normalisation(const Descriptor& descriptor, const fw_extract_config& bins,
                         BlobWriter& out) {
    if (is_peak_shape(descriptor)) return write_shape(descriptor, out);
    const fw_normalise_config& steps = descriptor.normalise;
    const bool uses_peak = descriptor.uses_peak();
    out.u16(static_cast<std::uint16_t>((steps.align ? 1 : 0) | (steps.compensate_range ? 2 : 0) |
                                       (steps.logarithm ? 4 : 0)));
    out.f32(uses_peak ? steps.target_bin : 0.0f);
    out.f32(steps.logarithm ? steps.floor_lsb : 0.0f);
    const BinChoice search =
        uses_peak ? descriptor.profile() : BinChoice{int{bins.first_bin}, int{bins.n_bins}};
    out.u16(static_cast<std::uint16_t>(search.first));
    out.u16(static_cast<std::uint16_t>(search.count));
}

struct NetworkFacts {
    std::vector<std::uint16_t> widths;
    float input_levels = 0.0f;
};

void write_facts(const Model& model, fw_arithmetic arithmetic, const NetworkFacts& network,
                 BlobWriter& out) {
    const fw_extract_config& descriptor = model.measurement->descriptor;
    out.u16(static_cast<std::uint16_t>(arithmetic));
    out.u16(model.monitor ? 1 : 0);
    out.u16(static_cast<std::uint16_t>(network.widths.size()));
    out.u16(static_cast<std::uint16_t>(model.n_features()));
    out.u16(static_cast<std::uint16_t>(model.n_classes()));
    out.u16(is_peak_shape(descriptor_of(model)) ? FW_FEATURES_PEAK_SHAPE : FW_FEATURES_RANGE_BINS);
    out.u16(is_peak_shape(descriptor_of(model)) ? 0 : descriptor.first_bin);
    out.u16(descriptor.n_bins);
    out.u16(static_cast<std::uint16_t>(descriptor.window));
    out.u16(static_cast<std::uint16_t>(descriptor.integration));
    out.u16(static_cast<std::uint16_t>(descriptor.path));
    write_normalisation(descriptor_of(model), descriptor, out);
    write_chirp(model.measurement->chirp, out);
    for (std::size_t l = 0; l < FW_MLP_MAX_LAYERS; ++l)
        out.u16(l < network.widths.size() ? network.widths[l] : 0);
    out.u16(0);
    out.f32(network.input_levels);
    out.f32(model.monitor ? model.monitor->suspicious_squared : 0.0f);
    out.u32(0);
}

void write_real(const FoldedModel& folded, BlobWriter& out) {
    out.floats(folded.input_mean);
    out.floats(folded.input_scale);
    for (const AffineLayer<float>& layer : folded.layers) {
        out.floats(layer.weight);
        out.floats(layer.bias);
    }
}

void write_integers(const IntegerModel& integers, BlobWriter& out) {
    out.floats(integers.input_mean);
    out.floats(integers.input_scale);
    for (const IntegerLayer& layer : integers.layers) {
        for (const std::int8_t value : layer.bytes) out.byte(value);
        for (const std::int16_t value : layer.halves) out.u16(static_cast<std::uint16_t>(value));
        out.pad();
        out.words(layer.bias);
        out.words(layer.multiplier);
        out.words(layer.shift);
        out.floats(layer.scale);
    }
}

void close(BlobWriter& out) {
    std::vector<std::uint8_t>& bytes = out.bytes();
    fw_write_u32(bytes.data() + 8, static_cast<std::uint32_t>(bytes.size()));
    fw_write_u32(bytes.data() + 12,
                 fw_crc32(bytes.data() + start_bytes, bytes.size() - start_bytes));
}

/// std::vector's memory suits any type, so it is aligned as fw_model_open wants it.
void expect_opens(const std::vector<std::uint8_t>& blob) {
    fw_model opened;
    const fw_status status = fw_model_open(blob.data(), blob.size(), &opened);
    if (status != FW_OK)
        throw InputError(
            format("the firmware refuses this model with {}: {}", fw_status_name(status),
                   status == FW_ERR_NAME ? "class_names: give each class a name of its own in UTF-8"
                   : status == FW_ERR_VALUE
                       ? "input_scale, weights or monitor: a number is out of range; train it again"
                       : "measurement: bins or chirp are out of its range (firmware/fw_model.h)"));
}

}  // namespace

std::vector<std::uint8_t> model_blob(const Model& model, fw_arithmetic arithmetic) {
    check(model);
    const FoldedModel folded = fold(model);
    NetworkFacts network;
    for (const AffineLayer<float>& layer : folded.layers)
        network.widths.push_back(static_cast<std::uint16_t>(layer.n_out));
    std::optional<IntegerModel> integers;
    if (arithmetic != FW_ARITHMETIC_FLOAT) {
        integers = quantise(model, arithmetic == FW_ARITHMETIC_INT8 ? FW_INT8 : FW_INT16);
        network.input_levels = integers->input_levels;
    }
    BlobWriter out;
    for (const char letter : {'R', 'F', 'W', 'M'}) out.byte(static_cast<std::int8_t>(letter));
    out.u16(is_peak_shape(descriptor_of(model)) ? version_with_kinds : version_of_range_bins);
    out.u16(0);
    out.u32(0);
    out.u32(0);
    write_facts(model, arithmetic, network, out);
    for (const std::string& name : model.class_names) out.name(name);
    integers ? write_integers(*integers, out) : write_real(folded, out);
    if (model.monitor) {
        out.floats(model.monitor->mean);
        out.floats(model.monitor->whitening);
        out.floats(model.monitor->centre);
    }
    close(out);
    expect_opens(out.bytes());
    return out.bytes();
}

std::string blob_as_c(const std::vector<std::uint8_t>& blob, const std::string& name) {
    check_c_name(name);
    constexpr std::size_t per_line = 16;
    std::string text = format(
        "/* Generated by `specula export model`; do not edit. */\n#include <stddef.h>\n\n"
        "extern const unsigned char {0}[{1}];\nextern const size_t {0}_bytes;\n\n"
        "const size_t {0}_bytes = {1};\n"
        "_Alignas(4) const unsigned char {0}[{1}] = {{",
        name, blob.size());
    for (std::size_t i = 0; i < blob.size(); ++i)
        text += format("{}0x{:02x},", i % per_line == 0 ? "\n    " : " ", blob[i]);
    return text + "\n};\n";
}

}  // namespace specula
