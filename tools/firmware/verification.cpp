#include "tools/firmware/verification.hpp"

#include <cstring>
#include <fstream>

#include "classifier/descriptor.hpp"
#include "classifier/model_blob.hpp"
#include "firmware/fw_bytes.h"
#include "firmware/fw_classify.h"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/firmware/process.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t record_counts = 7, record_scores = 4;  // firmware/port/fw_runner.c
constexpr std::size_t head_bytes = 4 * (record_counts + record_scores);

/// Places of counts in a record.
enum RecordCount { count_status, count_saturated, count_dead, count_bins, count_inputs };
constexpr std::size_t count_suspicious = record_counts - 1;

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw SystemError(file.string() + ": cannot be read");
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Where the parts of a record are.
struct RecordShape {
    std::size_t n_features = 0;
    std::size_t n_classes = 0;
    std::size_t bytes() const { return head_bytes + 4 * (n_features + 2 * n_classes); }
};

bool differ(const std::string& a, const std::string& b, std::size_t at, std::size_t n) {
    return a.compare(at, n, b, at, n) != 0;
}

Mismatches compare_records(const std::string& a, const std::string& b, const RecordShape& shape) {
    Mismatches found;
    const std::size_t features = 4 * shape.n_features, classes = 4 * shape.n_classes;
    if (a.size() != b.size() || a.size() % shape.bytes() != 0) {
        found.rest = std::max(a.size(), b.size()) / shape.bytes();
        return found;
    }
    for (std::size_t at = 0; at < a.size(); at += shape.bytes()) {
        found.rest += differ(a, b, at, head_bytes);
        found.features += differ(a, b, at + head_bytes, features);
        found.logits += differ(a, b, at + head_bytes + features, classes);
        found.probabilities += differ(a, b, at + head_bytes + features + classes, classes);
    }
    return found;
}

std::size_t count_different_bytes(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) n += a[i] != b[i];
    return n;
}

void put(std::string& out, std::uint32_t value) {
    std::uint8_t bytes[4];
    fw_write_u32(bytes, value);
    out.append(reinterpret_cast<const char*>(bytes), 4);
}

void put(std::string& out, float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    put(out, bits);
}

/// A record as the runner writes it (firmware/port/fw_runner.c), by the library linked here.
void append_record(const fw_model& model, const fw_frame& frame, std::vector<float>& scratch,
                   std::string& records) {
    fw_result result{};
    const fw_status status =
        fw_classify(&model, &frame, scratch.data(), scratch.size() * sizeof(float), &result);
    for (const std::uint32_t count :
         {static_cast<std::uint32_t>(status), result.quality.n_saturated,
          result.quality.n_dead_rows, result.n_saturated_bins,
          static_cast<std::uint32_t>(result.n_clipped_inputs),
          static_cast<std::uint32_t>(result.label), result.suspicious ? 1u : 0u})
        put(records, count);
    for (const float score : {result.probability, result.max_logit, result.energy, result.squared})
        put(records, score);
    for (std::size_t i = 0; i < model.n_features; ++i) put(records, result.features[i]);
    for (std::size_t i = 0; i < model.n_classes; ++i) put(records, result.logits[i]);
    for (std::size_t i = 0; i < model.n_classes; ++i) put(records, result.probabilities[i]);
}

std::string records_of_library(const std::vector<std::uint8_t>& blob, const Dataset& frames) {
    fw_model model;
    SPECULA_EXPECT(fw_model_open(blob.data(), blob.size(), &model) == FW_OK);
    std::vector<float> scratch(fw_classify_scratch(&model) / sizeof(float));
    std::string records;
    for (std::size_t i = 0; i < frames.n_frames(); ++i)
        append_record(model, frames.frame(i), scratch, records);
    return records;
}

/// Frames in which one of the counts is not 0.
std::size_t count_nonzero(const std::string& records, const RecordShape& shape, std::size_t which) {
    std::size_t n = 0;
    for (std::size_t at = 4 * which; at < records.size(); at += shape.bytes())
        n += fw_read_u32(reinterpret_cast<const std::uint8_t*>(records.data()) + at) != 0;
    return n;
}

FrameFlags flags_in(const std::string& records, const RecordShape& shape) {
    const auto count = [&](std::size_t which) { return count_nonzero(records, shape, which); };
    return {.refused = count(count_status),
            .saturated = count(count_saturated),
            .dead = count(count_dead),
            .cut_bins = count(count_bins),
            .clipped_inputs = count(count_inputs),
            .suspicious = count(count_suspicious)};
}

std::vector<std::uint8_t> blob_of(Model model, const Variant& variant) {
    model.measurement->descriptor.path = variant.path;
    return model_blob(model, variant.arithmetic);
}

void write_blob(const std::vector<std::uint8_t>& blob, const fs::path& file) {
    write_file_atomically(file, std::string(blob.begin(), blob.end()));
}

/// What to do where the runner is not beside the program: in a build folder, or in another.
std::string runner_remedy(const fs::path& folder) {
    return fs::exists(folder / "CMakeCache.txt")
               ? format("build it (cmake --build {} --target fw_runner)", folder.string())
               : format("copy it to {} from the folder that specula was copied from, where it is "
                        "built with it",
                        folder.string());
}

void run_on_host(const Workplace& place, std::vector<std::string> words) {
    words.insert(words.begin(), place.host_runner.string());
    output_of({.words = std::move(words),
               .folder = place.folder,
               .package = {},
               .remedy = runner_remedy(place.host_runner.parent_path())});
}

VariantResult verify_variant(const VerifyInput& input, const Variant& variant,
                             const Workplace& place, const TargetBuild& build) {
    const std::vector<std::uint8_t> blob = blob_of(input.model, variant);
    write_blob(blob, place.folder / "model.rfwm");
    run_on_host(place, {"run", "model.rfwm", "frames.bin", "host.records", "host.uart"});
    emulate(build, {.arguments = {"run", "model.rfwm", "frames.bin", "target.records", "none"},
                    .folder = place.folder,
                    .uart = "target.uart",
                    .counted = false,
                    .trace = {}});
    // The self-test fails where this machine or the emulated one computes other bits.
    run_on_host(place, {"test", "model.rfwm"});
    emulate(build, {.arguments = {"test", "model.rfwm"},
                    .folder = place.folder,
                    .uart = {},
                    .counted = false,
                    .trace = {}});
    const RecordShape shape{input.model.n_features(), input.model.n_classes()};
    const std::string host = content_of(place.folder / "host.records");
    const std::string host_uart = content_of(place.folder / "host.uart");
    VariantResult result{.variant = variant,
                         .n_frames = host.size() / shape.bytes(),
                         .n_uart_bytes = host_uart.size(),
                         .flags = flags_in(host, shape),
                         .host_target = {},
                         .host_library = {}};
    result.host_target = compare_records(host, content_of(place.folder / "target.records"), shape);
    result.host_target.uart_bytes =
        count_different_bytes(host_uart, content_of(place.folder / "target.uart"));
    result.host_library = compare_records(host, records_of_library(blob, input.frames), shape);
    return result;
}

}  // namespace

const std::vector<Variant>& all_variants() {
    static const std::vector<Variant> variants{
        {"float32", FW_ARITHMETIC_FLOAT, FW_RANGE_FLOAT},
        {"int16", FW_ARITHMETIC_INT16, FW_RANGE_FLOAT},
        {"int8", FW_ARITHMETIC_INT8, FW_RANGE_FLOAT},
        {"float32, HWA-like spectrum", FW_ARITHMETIC_FLOAT, FW_RANGE_HWA_LIKE},
        {"int16, HWA-like spectrum", FW_ARITHMETIC_INT16, FW_RANGE_HWA_LIKE},
        {"int8, HWA-like spectrum", FW_ARITHMETIC_INT8, FW_RANGE_HWA_LIKE}};
    return variants;
}

std::vector<Variant> variants_of(const Model& model) {
    std::vector<Variant> variants = all_variants();
    if (descriptor_of(model).is_relative())
        std::erase_if(variants, [](const Variant& each) { return each.path != FW_RANGE_FLOAT; });
    return variants;
}

std::size_t Verification::mismatches() const {
    std::size_t n = 0;
    for (const VariantResult& variant : variants)
        n += variant.host_target.total() + variant.host_library.total();
    return n;
}

void write_frames(const Dataset& frames, const fs::path& file) {
    std::string bytes;
    for (const int count :
         {frames.n_samples, frames.n_rx, frames.n_chirps, static_cast<int>(frames.n_frames())})
        put(bytes, static_cast<std::uint32_t>(count));
    const std::size_t header = bytes.size();
    bytes.resize(header + 2 * frames.adc.size());
    for (std::size_t i = 0; i < frames.adc.size(); ++i)
        fw_write_u16(reinterpret_cast<std::uint8_t*>(bytes.data()) + header + 2 * i,
                     static_cast<std::uint16_t>(frames.adc[i]));
    write_file_atomically(file, bytes);
}

std::map<std::string, StageCost> measure_stages(const TargetBuild& build, const fs::path& folder,
                                                const Model& model, const Variant& variant) {
    write_blob(blob_of(model, variant), folder / "model.rfwm");
    const std::vector<std::string> arguments{"model.rfwm", "frames.bin"};
    const auto instructions = count_instructions(build, folder, arguments);
    const auto cycles = estimate_cycles(build, folder, arguments);
    std::map<std::string, StageCost> costs;
    for (const auto& [stage, count] : instructions)
        costs[stage] = {.instructions = count, .cycles = cycles.at(stage)};
    return costs;
}

Verification verify_firmware(const VerifyInput& input, const Workplace& place) {
    Verification verification;
    const std::vector<Variant> variants = variants_of(input.model);
    constexpr std::size_t n_measured = 3;  // the first variants: one per arithmetic
    Progress progress("Verifying", "steps", 1 + variants.size() + n_measured);
    const TargetBuild build = build_for_target(place.home, place.build);
    ++progress.done();
    write_frames(input.frames, place.folder / "frames.bin");
    for (const Variant& variant : variants) {
        verification.variants.push_back(verify_variant(input, variant, place, build));
        ++progress.done();
    }
    for (std::size_t i = 0; i < n_measured; ++i, ++progress.done())
        verification.stages[variants[i].name] =
            measure_stages(build, place.folder, input.model, variants[i]);
    verification.modules = read_module_sizes(build.map);
    const fs::path library = build.folder / "CMakeFiles/specula_firmware.dir";
    verification.stacks = public_stacks(library);
    verification.foreign = foreign_symbols(
        output_of({{"arm-none-eabi-nm", build.archive.string()}, {}, "binutils-arm-none-eabi"}));
    const std::vector<std::uint8_t> blob = blob_of(input.model, variants.front());
    fw_model model;
    SPECULA_EXPECT(fw_model_open(blob.data(), blob.size(), &model) == FW_OK);
    verification.model_bytes = blob.size();
    verification.scratch_bytes = fw_classify_scratch(&model);
    return verification;
}

}  // namespace specula
