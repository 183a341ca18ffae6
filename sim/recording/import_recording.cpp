#include "sim/recording/import_recording.hpp"

#include <algorithm>
#include <fstream>

#include "sim/core/version.hpp"
#include "sim/recording/adc_injection.hpp"
#include "sim/recording/csv_rows.hpp"
#include "sim/recording/dca1000_packets.hpp"
#include "sim/recording/import_arrays.hpp"
#include "sim/recording/import_tables.hpp"
#include "sim/recording/infineon_config.hpp"
#include "sim/recording/order_check.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

/// A recording on its way to a dataset.
struct Draft {
    Dataset dataset;
    std::size_t n_recordings = 1;
    LabelColumns columns;
    std::vector<std::string> notes;
};

std::string read_file(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        throw InputError("is no file that can be read; check the path");
    std::ifstream in(file, std::ios::binary);
    std::string content(fs::file_size(file), '\0');
    in.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (!in || content.empty()) throw InputError("is empty or cannot be read; check the file");
    return content;
}

void take_cube(CodeCube cube, Draft& draft) {
    draft.dataset.n_chirps = static_cast<int>(cube.n_chirps);
    draft.dataset.n_rx = static_cast<int>(cube.n_rx);
    draft.dataset.n_samples = static_cast<int>(cube.n_samples);
    draft.dataset.adc = std::move(cube.in_phase);
    draft.dataset.adc_quadrature = std::move(cube.quadrature);
    draft.dataset.truth.resize(cube.n_frames);
    draft.n_recordings = cube.n_recordings;
}

/// Takes a cube whose order somebody declared, unless the codes speak against it.
void take_declared(CodeCube cube, const RecordingManifest& manifest, Draft& draft) {
    constexpr double clear = 4.0;  // a recording of an IWRL6432 gives 5.7 when exchanged
    const double suspicion = manifest.trust_axes ? 0.0 : interleaving_suspicion(cube);
    if (suspicion > clear)
        fail_at(0,
                format("from sample to sample, the codes jump {:.1f} times as much as with rx and "
                       "sample exchanged",
                       suspicion),
                "exchange them in axes of a manifest's [layout], or say trust_axes = true there");
    take_cube(std::move(cube), draft);
}

/// The order of a flat file: axes of the manifest or `usual`, one of whose lengths may be open.
AxisOrder flat_order(const RecordingManifest& manifest, const std::vector<std::string>& usual,
                     std::size_t n_codes) {
    AxisOrder order{manifest.axes.empty() ? usual : manifest.axes, {}};
    std::size_t n_open = 0;
    for (const std::string& axis : order.axes) {
        const auto given = manifest.length.find(axis);
        const bool one = axis == "tx" || (axis == "chirp" && !manifest.length.contains("chirp"));
        const std::size_t length = axis == "iq"                     ? 2
                                   : given != manifest.length.end() ? given->second
                                   : one                            ? 1
                                                                    : 0;
        if (length == 0 && ++n_open > 1)
            throw InputError(
                format("{}: its length is not known; give chirps, rx and samples in "
                       "[layout] of a manifest, or a radar",
                       axis));
        order.shape.push_back(length);
    }
    return with_open_axis(order, n_codes);
}

void take_flat(Bytes bytes, Packing packing, const RecordingManifest& manifest,
               const std::vector<std::string>& usual, Draft& draft) {
    const auto codes = unpack_codes(bytes, packing);
    take_declared(arrange(codes, flat_order(manifest, usual, codes.size())), manifest, draft);
}

void import_adc(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    take_flat(bytes_in(content), manifest.packing.value_or(Packing::int16), manifest,
              {"frame", "chirp", "rx", "sample"}, draft);
}

void import_dca1000(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    std::string content = read_file(input);
    if (manifest.packets) content = dca1000_payload(bytes_in(content));
    const Packing packing = manifest.packing.value_or(Packing::int16);
    std::vector<std::string> usual{"frame", "chirp", "rx", "sample"};
    if (packing == Packing::lvds_iq) usual.emplace_back("iq");
    take_flat(bytes_in(content), packing, manifest, usual, draft);
}

void import_rdif(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    std::string content = read_file(input);
    if (manifest.packets) content = dca1000_payload(bytes_in(content));
    take_flat(bytes_in(content), Packing::rdif_swizzle_2, manifest,
              {"frame", "chirp", "tx", "sample", "rx"}, draft);
}

void import_injection(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    const AdcInjection injection = read_adc_injection(bytes_in(content));
    const auto given = manifest.length.find("tx");
    const std::size_t n_tx = given == manifest.length.end() ? 1 : given->second;
    if (injection.n_virtual % n_tx != 0)
        throw InputError(
            format("byte 4: numVirtualAntennas = {}: is no multiple of tx = {}; give "
                   "the right tx",
                   injection.n_virtual, n_tx));
    // The TX take turns: a frame's chirps are those that are sent.
    take_cube(arrange(injection.codes, {{"frame", "chirp", "rx", "sample"},
                                        {injection.n_frames, injection.n_chirps * n_tx,
                                         injection.n_virtual / n_tx, injection.n_samples}}),
              draft);
}

/// What `work` returns; its complaints begin with the name of a part of the input.
auto inside(const std::string& name, auto work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
}

void take_array(const NpyArray& array, const RecordingManifest& manifest, Draft& draft) {
    if (is_feature_table(array, manifest)) return take_features(array, draft.dataset);
    take_declared(arrange(codes_of(array, manifest.wrapped), order_of(array, manifest)), manifest,
                  draft);
}

void import_npy(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    take_array(read_npy(bytes_in(content)), manifest, draft);
}

void import_npz(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    const ZipArchive archive(bytes_in(content));
    std::string member = manifest.member + ".npy";
    if (manifest.member.empty() && archive.names().size() == 1) member = archive.names()[0];
    if (!archive.has(member))
        throw InputError(
            format("member = \"{}\": is not in the archive; in [layout] of a manifest, "
                   "name one of {}",
                   manifest.member, quoted_list(archive.names())));
    const std::vector<std::uint8_t> array = archive.extract(member);
    inside(member, [&] { take_array(read_npy(array), manifest, draft); });
    draft.columns = label_members(archive, manifest, draft.dataset.n_frames(), draft.n_recordings);
}

void import_infineon(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const InfineonConfig config = inside(
        "config.json", [&] { return read_infineon_config(read_file(input / "config.json")); });
    const std::string content = inside("radar.npy", [&] { return read_file(input / "radar.npy"); });
    const NpyArray array = inside("radar.npy", [&] { return read_npy(bytes_in(content)); });
    const std::vector<std::size_t> due{config.n_rx, config.n_chirps, config.n_samples};
    if (array.shape.size() != 4 || !std::equal(due.begin(), due.end(), array.shape.begin() + 1))
        fail_at(array.data_offset, "radar.npy has not the shape that config.json gives",
                "keep the two files of one recording together");
    if (array.kind != 'u' || array.item_bytes != 2)
        fail_at(array.data_offset, "radar.npy does not hold codes of 16 bits without sign",
                "name a recording as Infineon's tools write it");
    AxisOrder order{{"frame", "rx", "chirp", "sample"}, array.shape};
    std::vector<std::int16_t> codes(array.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double code = array.real(i) - infineon_mid_scale;
        if (code > 32767.0)
            fail_at(array.data_offset + 2 * i, format("{}: is no code of 12 bits", array.real(i)),
                    "is the file whole?");
        codes[i] = static_cast<std::int16_t>(code);
    }
    take_cube(arrange(codes, order), draft);
    if (manifest.bin_m == 0.0) draft.dataset.origin.bin_m = config.bin_m();
}

void import_uart(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    draft.notes = take_uart(read_uart(bytes_in(content)), draft.dataset);
    // A sensor counts on from session to session; where a manifest parts them, each begins at 0.
    if (manifest.parts.empty()) draft.columns["frame"] = frame_numbers(draft.dataset);
}

void import_csv(const fs::path& input, const RecordingManifest& manifest, Draft& draft) {
    const std::string content = read_file(input);
    draft.columns = take_csv(read_csv(bytes_in(content)), manifest, draft.dataset);
}

struct ImportFormat {
    std::string name;
    void (*import)(const fs::path&, const RecordingManifest&, Draft&);
    std::vector<std::string> takes;  ///< what of a manifest it makes use of; see given_in
};
const std::vector<ImportFormat>& import_formats() {
    static const std::vector<ImportFormat> all{
        {"adc", import_adc, {"axes", "packing", "trust_axes"}},
        {"dca1000", import_dca1000, {"axes", "packing", "packets", "trust_axes"}},
        {"rdif", import_rdif, {"axes", "packets", "trust_axes"}},
        {"injection", import_injection, {}},
        {"uart", import_uart, {}},
        {"infineon", import_infineon, {}},
        {"npy", import_npy, {"axes", "wrapped", "trust_axes"}},
        {"npz", import_npz, {"axes", "wrapped", "trust_axes", "member", "[labels]"}},
        {"csv", import_csv, {"features", "[labels]"}}};
    return all;
}

/// The parts of a manifest that only some formats have a use for.
std::vector<std::string> given_in(const RecordingManifest& manifest) {
    std::vector<std::string> given;
    if (!manifest.axes.empty()) given.emplace_back("axes");
    if (manifest.packing) given.emplace_back("packing");
    if (manifest.packets) given.emplace_back("packets");
    if (manifest.trust_axes) given.emplace_back("trust_axes");
    if (manifest.wrapped) given.emplace_back("wrapped");
    if (!manifest.member.empty()) given.emplace_back("member");
    if (!manifest.features.empty()) given.emplace_back("features");
    if (!manifest.columns.empty()) given.emplace_back("[labels]");
    return given;
}

void check_taken(const ImportFormat& format_of, const RecordingManifest& manifest) {
    for (const std::string& what : given_in(manifest))
        if (std::ranges::count(format_of.takes, what) == 0)
            throw InputError(
                format("{} in its manifest: means nothing for {}, which has no such thing; leave "
                       "it out{}",
                       what, format_of.name, what == "[labels]" ? " and give parts" : ""));
}

}  // namespace

const std::vector<std::string>& recording_formats() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const ImportFormat& each : import_formats()) list.push_back(each.name);
        return list;
    }();
    return names;
}

std::string guessed_format(const fs::path& input) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored))
        return fs::exists(input / "config.json", ignored) ? "infineon" : "";
    const std::string extension = input.extension().string();
    return extension == ".npy" || extension == ".npz" || extension == ".csv" ? extension.substr(1)
                                                                             : "";
}

ImportedRecording import_recording(const std::string& format_name, const fs::path& input,
                                   const RecordingManifest& manifest) {
    const auto found = std::ranges::find(import_formats(), format_name, &ImportFormat::name);
    if (found == import_formats().end())
        throw InputError(format("\"{}\": no such format; use {}", format_name,
                                quoted_list(recording_formats())));
    Draft draft;
    draft.dataset.sample_axis = manifest.sample_axis;
    draft.dataset.origin = {.condition = manifest.condition,
                            .experiment = manifest.source,
                            .version = program_version,
                            .radar = manifest.radar,
                            .bin_m = manifest.bin_m,
                            .source = "import " + format_name,
                            .recipe = {}};
    try {
        check_taken(*found, manifest);
        found->import(input, manifest, draft);
        apply_labels(manifest, draft.columns, draft.n_recordings, draft.dataset);
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", input.string(), error.what()));
    }
    return {std::move(draft.dataset), std::move(draft.notes)};
}

}  // namespace specula
