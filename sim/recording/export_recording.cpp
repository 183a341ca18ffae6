#include "sim/recording/export_recording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "firmware/fw_uart.h"
#include "sim/core/document.hpp"
#include "sim/recording/adc_injection.hpp"
#include "sim/recording/csv_rows.hpp"
#include "sim/recording/dca1000_packets.hpp"
#include "sim/recording/manifest.hpp"
#include "sim/recording/npy_array.hpp"
#include "sim/recording/uart_stream.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

struct Outgoing {
    const Dataset& dataset;
    const fs::path& out;
    const SentChirps& chirps;
};

CodeCube cube_of(const Dataset& dataset) {
    if (dataset.adc.empty())
        throw InputError("there are no codes in the dataset, only features; use npy, csv or uart");
    return {.n_frames = dataset.n_frames(),
            .n_chirps = static_cast<std::size_t>(dataset.n_chirps),
            .n_rx = static_cast<std::size_t>(dataset.n_rx),
            .n_samples = static_cast<std::size_t>(dataset.n_samples),
            .in_phase = dataset.adc,
            .quadrature = dataset.adc_quadrature};
}

void refuse_complex(const Dataset& dataset, const char* format_name) {
    if (!dataset.adc_quadrature.empty())
        throw InputError(
            format("the codes are complex, which {} cannot hold; use adc, dca1000 or "
                   "npy",
                   format_name));
}

std::string layout_of(const Dataset& dataset, const std::string& more) {
    return format("\n[layout]\nchirps = {}\nrx = {}\nsamples = {}\n{}", dataset.n_chirps,
                  dataset.n_rx, dataset.n_samples, more);
}

ExportedFile manifest_beside(const Outgoing& o, const std::string& layout) {
    return {o.out.string() + ".toml", manifest_of(o.dataset, layout)};
}

std::vector<std::string> axes_of(const Dataset& dataset) {
    std::vector<std::string> axes{"frame", "chirp", "rx", "sample"};
    if (!dataset.adc_quadrature.empty()) axes.emplace_back("iq");
    return axes;
}

std::vector<std::int16_t> ordered_codes(const Dataset& dataset,
                                        const std::vector<std::string>& axes) {
    return rearrange(cube_of(dataset), {axes, std::vector<std::size_t>(axes.size(), 0)});
}

std::vector<ExportedFile> export_adc(const Outgoing& o) {
    const auto axes = axes_of(o.dataset);
    const std::string more =
        axes.size() == 5 ? "axes = [\"frame\", \"chirp\", \"rx\", \"sample\", \"iq\"]\n" : "";
    return {{o.out, pack_codes(ordered_codes(o.dataset, axes), Packing::int16)},
            manifest_beside(o, layout_of(o.dataset, more))};
}

std::vector<ExportedFile> export_dca1000(const Outgoing& o) {
    const auto axes = axes_of(o.dataset);
    const bool is_complex = axes.size() == 5;
    return {{o.out, pack_codes(ordered_codes(o.dataset, axes),
                               is_complex ? Packing::lvds_iq : Packing::int16)},
            manifest_beside(o, layout_of(o.dataset, is_complex ? "packing = \"lvds_iq\"\n" : ""))};
}

std::vector<ExportedFile> export_rdif(const Outgoing& o) {
    refuse_complex(o.dataset, "rdif");
    const auto codes = ordered_codes(o.dataset, {"frame", "chirp", "tx", "sample", "rx"});
    return {{o.out, pack_codes(codes, Packing::rdif_swizzle_2)},
            manifest_beside(o, layout_of(o.dataset, ""))};
}

std::vector<ExportedFile> export_injection(const Outgoing& o) {
    refuse_complex(o.dataset, "injection");
    const CodeCube cube = cube_of(o.dataset);
    const std::size_t n_tx = o.chirps.n_tx;
    if (cube.n_chirps % n_tx != 0)
        throw InputError(format("{} chirps of a frame are no whole number for each of {} TX; name "
                                "the radar that sent them",
                                cube.n_chirps, n_tx));
    return {{o.out, write_adc_injection({.n_samples = cube.n_samples,
                                         .n_virtual = cube.n_rx * n_tx,
                                         .n_chirps = cube.n_chirps / n_tx,
                                         .n_frames = cube.n_frames,
                                         .codes = cube.in_phase})},
            manifest_beside(o, n_tx == 1 ? "" : format("\n[layout]\ntx = {}\n", n_tx))};
}

std::string npy_of_features(const Dataset& dataset) {
    std::string data;
    for (const double value : dataset.features)
        append_number(data, std::bit_cast<std::uint64_t>(value), 8);
    return write_npy("<f8", {dataset.n_frames(), dataset.feature_names.size()}, data);
}

std::vector<ExportedFile> export_npy(const Outgoing& o) {
    if (o.dataset.adc.empty()) return {{o.out, npy_of_features(o.dataset)}, manifest_beside(o, "")};
    const CodeCube cube = cube_of(o.dataset);
    const auto axes = axes_of(o.dataset);
    std::vector<std::size_t> shape{cube.n_frames, cube.n_chirps, cube.n_rx, cube.n_samples, 2};
    shape.resize(axes.size());
    const std::string data = pack_codes(ordered_codes(o.dataset, axes), Packing::int16);
    return {{o.out, write_npy("<i2", shape, data)}, manifest_beside(o, "")};
}

std::vector<ExportedFile> export_infineon(const Outgoing& o) {
    refuse_complex(o.dataset, "infineon");
    const CodeCube cube = cube_of(o.dataset);
    std::string data;
    for (const std::int16_t code : ordered_codes(o.dataset, {"frame", "rx", "chirp", "sample"})) {
        const int stored = code + infineon_mid_scale;
        if (stored < 0)
            throw InputError(
                format("code {}: is below the 12 bits of the format; use adc or npy", code));
        append_number(data, static_cast<std::uint64_t>(stored), 2);
    }
    InfineonConfig config = o.chirps.infineon;
    config.n_chirps = cube.n_chirps;
    config.n_samples = cube.n_samples;
    config.n_rx = cube.n_rx;
    return {{o.out / "radar.npy",
             write_npy("<u2", {cube.n_frames, cube.n_rx, cube.n_chirps, cube.n_samples}, data)},
            {o.out / "config.json", write_infineon_config(config)},
            manifest_beside(o, "")};
}

void check_features(const Dataset& dataset) {
    if (dataset.features.empty())
        throw InputError("there are no features in the dataset; extract them first");
}

/// Numbers of packets: those a sensor gave where they only rise, else 0, 1, 2...: a dataset counts
/// the frames of every session anew, a stream does not.
std::vector<std::uint32_t> packet_numbers(const Dataset& dataset) {
    const auto falls = [](const Truth& a, const Truth& b) { return b.frame <= a.frame; };
    const bool rises = std::ranges::adjacent_find(dataset.truth, falls) == dataset.truth.end();
    std::vector<std::uint32_t> numbers;
    for (const Truth& truth : dataset.truth)
        numbers.push_back(rises ? static_cast<std::uint32_t>(truth.frame)
                                : static_cast<std::uint32_t>(numbers.size()));
    return numbers;
}

std::vector<ExportedFile> export_uart(const Outgoing& o) {
    check_features(o.dataset);
    const std::size_t n_bins = o.dataset.feature_names.size();
    const std::size_t n_answers = o.dataset.answer_names.size();
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
    if (n_bins > most || n_answers > most ||
        fw_uart_size(static_cast<std::uint16_t>(n_bins), static_cast<std::uint16_t>(n_answers)) >
            FW_UART_MAX_BYTES)
        throw InputError(format("{} features: a packet holds at most {} bytes; use csv or npy",
                                n_bins, FW_UART_MAX_BYTES));
    const auto numbers = packet_numbers(o.dataset);
    std::string stream;
    for (std::size_t i = 0; i < o.dataset.n_frames(); ++i) {
        UartFrame frame{.number = numbers[i]};
        for (std::size_t k = 0; k < n_bins; ++k) {
            const double value = o.dataset.features[i * n_bins + k];
            if (!(value >= 0.0 && value <= 4294967295.0) || value != std::floor(value))
                throw InputError(
                    format("{} = {} in frame {}: is no whole number of 32 bits, as "
                           "range profiles are; use csv or npy",
                           o.dataset.feature_names[k], value, i));
            frame.profile.push_back(static_cast<std::uint32_t>(value));
        }
        for (std::size_t k = 0; k < n_answers; ++k)
            frame.probability.push_back(o.dataset.probability[i * n_answers + k]);
        const auto best = std::max_element(frame.probability.begin(), frame.probability.end());
        frame.class_type = static_cast<std::uint32_t>(best - frame.probability.begin());
        stream += uart_packet(frame);
    }
    return {{o.out, stream}, manifest_beside(o, "")};
}

std::vector<ExportedFile> export_csv(const Outgoing& o) {
    check_features(o.dataset);
    const std::size_t n = o.dataset.feature_names.size();
    std::string text = "class,world,sample,session,frame";
    if (o.dataset.has_views) text += ",view";
    for (const std::string& name : o.dataset.feature_names) text += "," + csv_cell(name);
    text += "\n";
    for (std::size_t i = 0; i < o.dataset.n_frames(); ++i) {
        const Truth& truth = o.dataset.truth[i];
        text += format("{},{},{},{},{}", csv_cell(o.dataset.class_names.at(truth.label)),
                       truth.world, truth.sample, truth.session, truth.frame);
        if (o.dataset.has_views) text += format(",{}", truth.view);
        for (std::size_t k = 0; k < n; ++k) text += format(",{}", o.dataset.features[i * n + k]);
        text += "\n";
    }
    return {{o.out, text}};
}

struct Format {
    std::string name;
    std::vector<ExportedFile> (*write)(const Outgoing&);
};
const std::vector<Format>& formats() {
    static const std::vector<Format> all{{"adc", export_adc},   {"dca1000", export_dca1000},
                                         {"rdif", export_rdif}, {"injection", export_injection},
                                         {"uart", export_uart}, {"infineon", export_infineon},
                                         {"npy", export_npy},   {"csv", export_csv}};
    return all;
}

}  // namespace

const std::vector<std::string>& export_formats() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Format& each : formats()) list.push_back(each.name);
        return list;
    }();
    return names;
}

bool carries_features(const std::string& format) {
    return format == "csv" || format == "uart";
}

std::vector<ExportedFile> export_recording(const std::string& format_name, const Dataset& dataset,
                                           const fs::path& out, const SentChirps& chirps) {
    const auto found = std::ranges::find(formats(), format_name, &Format::name);
    if (found == formats().end())
        throw InputError(
            format("\"{}\": no such format; use {}", format_name, quoted_list(export_formats())));
    return found->write({dataset, out, chirps});
}

}  // namespace specula
