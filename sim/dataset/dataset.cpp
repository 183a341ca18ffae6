#include "sim/dataset/dataset.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/hdf5_file.hpp"

namespace specula {

namespace {

constexpr const char* format_name = "specula-dataset";
constexpr int format_version = 2;
constexpr int oldest_version = 1;  ///< without left_out, source and sample_axis: all simulated
constexpr const char* left_out_in_version_1 = "/adc_quadrature,/features,/probability,/group/view";
constexpr std::size_t most_features = 4096;
constexpr std::size_t column_rows = 1 << 16;  ///< rows per chunk of one-number columns
constexpr std::size_t most_per_axis = 65535;  ///< chirps, RX or samples: a fw_frame counts no more

template <typename T>
struct Column {
    const char* name;
    const char* meaning;
    T Truth::*member;
};

constexpr Column<std::int32_t> id_columns[] = {
    {"world", "draw of room and samples", &Truth::world},
    {"sample", "physical piece", &Truth::sample},
    {"session", "one placement and warm-up", &Truth::session},
    {"frame", "number in its session", &Truth::frame},
};

template <typename T>
std::vector<T> column_of(const std::vector<Truth>& truth, T Truth::*member) {
    std::vector<T> values;
    values.reserve(truth.size());
    for (const Truth& frame : truth) values.push_back(frame.*member);
    return values;
}

/// The tables that a dataset does not have, as the file says it: `/a,/b`.
std::string left_out(const Dataset& dataset) {
    std::string list;
    const auto leave_out = [&list](bool absent, const std::string& table) {
        if (absent) list += (list.empty() ? "" : ",") + table;
    };
    leave_out(dataset.adc.empty(), "/adc");
    leave_out(dataset.adc_quadrature.empty(), "/adc_quadrature");
    leave_out(dataset.features.empty(), "/features");
    leave_out(dataset.probability.empty(), "/probability");
    leave_out(!dataset.has_views, "/group/view");
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        leave_out(dataset.unknown_truth[i], std::string("/truth/") + truth_columns[i].name);
    return list;
}

std::set<std::string> parted(const std::string& list) {
    std::set<std::string> names;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        names.insert(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

/// The file being read, and its name for messages.
struct OpenDataset {
    const Hdf5File& in;
    const std::filesystem::path& file;
};

template <typename T>
void fill_column(const OpenDataset& source, const std::string& name, T Truth::*member,
                 std::vector<Truth>& truth) {
    const auto values = source.in.read<T>(name);
    if (values.size() != truth.size())
        throw InputError(format("{}: a column {} of {} rows beside {} frames", source.file.string(),
                                name, values.size(), truth.size()));
    for (std::size_t i = 0; i < truth.size(); ++i) truth[i].*member = values[i];
}

void write_origin(Hdf5File& out, const Dataset& dataset) {
    const Origin& origin = dataset.origin;
    out.set_text("/", "format", format_name);
    out.set_number("/", "format_version", format_version);
    out.set_text("/", "software", "specula");
    out.set_text("/", "software_version", origin.version);
    out.set_text("/", "condition", origin.condition);
    out.set_text("/", "experiment_toml", origin.experiment);
    out.set_text("/", "seed", std::to_string(origin.seed));
    out.set_text("/", "radar", origin.radar);
    out.set_number("/", "range_bin_m", origin.bin_m);
    out.set_texts("/", "class_names", dataset.class_names);
    out.set_text("/", "source", origin.source);
    out.set_text("/", "sample_axis", dataset.sample_axis == SampleAxis::range ? "range" : "beat");
    out.set_text("/", "left_out", left_out(dataset));
}

void check_version(const Hdf5File& in, const std::filesystem::path& file) {
    if (in.text("/", "format") != format_name)
        throw InputError(file.string() +
                         ": /@format: is not a dataset of this program; write one "
                         "with specula study, simulate or import");
    const double version = in.number("/", "format_version");
    if (version < oldest_version || version > format_version || version != std::floor(version))
        throw InputError(
            format("{}: /@format_version = {}: this program reads versions {} to {}; "
                   "use the program that wrote it",
                   file.string(), version, oldest_version, format_version));
}

Origin read_origin(const Hdf5File& in, const std::filesystem::path& file) {
    Origin origin;
    origin.version = in.text("/", "software_version");
    origin.condition = in.text("/", "condition");
    origin.experiment = in.text("/", "experiment_toml");
    origin.radar = in.text("/", "radar");
    origin.bin_m = in.number("/", "range_bin_m");
    const std::string seed = in.text("/", "seed");
    const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), origin.seed);
    if (error != std::errc{} || end != seed.data() + seed.size())
        throw InputError(file.string() + ": /@seed: is not a number; the file is damaged");
    return origin;
}

void write_adc(Hdf5File& out, const Dataset& dataset, const std::string& name,
               const std::vector<std::int16_t>& codes) {
    if (codes.empty()) return;
    out.write(name,
              {dataset.n_frames(), static_cast<std::size_t>(dataset.n_chirps),
               static_cast<std::size_t>(dataset.n_rx), static_cast<std::size_t>(dataset.n_samples)},
              1, codes);
    out.set_text(name, "units", "LSB");
    out.set_texts(name, "axis_labels", {"frame", "chirp", "rx", "sample"});
}

void write_rows(Hdf5File& out, const Dataset& dataset) {
    const std::size_t n = dataset.n_frames();
    if (!dataset.features.empty()) {
        out.write("/features", {n, dataset.feature_names.size()}, column_rows, dataset.features);
        out.set_texts("/features", "feature_names", dataset.feature_names);
    }
    if (!dataset.probability.empty()) {
        out.write("/probability", {n, dataset.answer_names.size()}, column_rows,
                  dataset.probability);
        out.set_texts("/probability", "class_names", dataset.answer_names);
    }
}

/// A table of one row per frame, all of it finite.
template <typename T>
std::vector<T> read_rows(const Hdf5File& in, const std::filesystem::path& file,
                         const std::string& name, const std::vector<std::size_t>& shape) {
    if (in.shape(name) != shape)
        throw InputError(
            format("{}: {}: is not one row of {} numbers per frame; the file is "
                   "damaged",
                   file.string(), name, shape[1]));
    std::vector<T> values = in.read<T>(name);
    if (!std::ranges::all_of(values, [](T value) { return std::isfinite(value); }))
        throw InputError(format("{}: {}: holds a value that is not finite; the file is damaged",
                                file.string(), name));
    return values;
}

void read_adc(const Hdf5File& in, const std::filesystem::path& file, Dataset& dataset) {
    const auto shape = in.shape("/adc");
    const auto possible = [](std::size_t n) { return n >= 1 && n <= most_per_axis; };
    if (shape.size() != 4 || !std::all_of(shape.begin() + 1, shape.end(), possible))
        throw InputError(file.string() +
                         ": /adc: is not (frame, chirp, rx, sample); the file is damaged");
    dataset.n_chirps = static_cast<int>(shape[1]);
    dataset.n_rx = static_cast<int>(shape[2]);
    dataset.n_samples = static_cast<int>(shape[3]);
    dataset.adc = in.read<std::int16_t>("/adc");
    dataset.truth.resize(shape[0]);
}

void read_quadrature(const Hdf5File& in, const std::filesystem::path& file, Dataset& dataset) {
    if (in.shape("/adc_quadrature") != in.shape("/adc"))
        throw InputError(file.string() +
                         ": /adc_quadrature: has not the shape of /adc; the file is damaged");
    dataset.adc_quadrature = in.read<std::int16_t>("/adc_quadrature");
}

void read_features(const Hdf5File& in, const std::filesystem::path& file, Dataset& dataset) {
    dataset.feature_names = in.texts("/features", "feature_names");
    const std::size_t n = dataset.n_samples > 0 ? dataset.n_frames() : in.shape("/features")[0];
    dataset.features = read_rows<double>(in, file, "/features", {n, dataset.feature_names.size()});
    dataset.truth.resize(n);
}

void read_columns(const OpenDataset& source, const std::set<std::string>& absent,
                  Dataset& dataset) {
    fill_column(source, "/label", &Truth::label, dataset.truth);
    for (const auto& column : id_columns)
        fill_column(source, std::string("/group/") + column.name, column.member, dataset.truth);
    dataset.has_views = !absent.contains("/group/view");
    if (dataset.has_views) fill_column(source, "/group/view", &Truth::view, dataset.truth);
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        const std::string name = std::string("/truth/") + truth_columns[i].name;
        dataset.unknown_truth[i] = absent.contains(name);
        if (!absent.contains(name))
            fill_column(source, name, truth_columns[i].member, dataset.truth);
    }
}

template <typename T>
void write_column(Hdf5File& out, const Dataset& dataset, const std::string& name, T Truth::*member,
                  const char* meaning) {
    out.write(name, {dataset.n_frames()}, column_rows, column_of(dataset.truth, member));
    out.set_text(name, "long_name", meaning);
}

}  // namespace

void write_dataset(const std::filesystem::path& file, const Dataset& dataset) {
    SPECULA_EXPECT(dataset.feature_names.size() <= most_features);
    Hdf5File out = Hdf5File::create(file);
    write_origin(out, dataset);
    write_adc(out, dataset, "/adc", dataset.adc);
    write_adc(out, dataset, "/adc_quadrature", dataset.adc_quadrature);
    write_rows(out, dataset);
    out.write("/label", {dataset.n_frames()}, column_rows, column_of(dataset.truth, &Truth::label));
    out.set_texts("/label", "class_names", dataset.class_names);

    out.create_group("/group");
    for (const auto& column : id_columns)
        write_column(out, dataset, std::string("/group/") + column.name, column.member,
                     column.meaning);
    if (dataset.has_views)
        write_column(out, dataset, "/group/view", &Truth::view,
                     "side or place from which recordings look at their samples");
    out.create_group("/truth");
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        if (dataset.unknown_truth[i]) continue;
        const TruthColumn& column = truth_columns[i];
        const std::string name = std::string("/truth/") + column.name;
        write_column(out, dataset, name, column.member, column.meaning);
        out.set_text(name, "units", column.unit);
    }
    out.publish();
}

Dataset read_dataset(const std::filesystem::path& file) {
    const Hdf5File in = Hdf5File::open(file);
    check_version(in, file);
    Dataset dataset;
    dataset.origin = read_origin(in, file);
    dataset.class_names = in.texts("/", "class_names");
    std::set<std::string> absent = parted(left_out_in_version_1);
    if (in.number("/", "format_version") > 1.0) {
        dataset.origin.source = in.text("/", "source");
        if (in.text("/", "sample_axis") == "range") dataset.sample_axis = SampleAxis::range;
        absent = parted(in.text("/", "left_out"));
    }
    if (!absent.contains("/adc") || absent.contains("/features")) read_adc(in, file, dataset);
    if (!absent.contains("/adc_quadrature")) read_quadrature(in, file, dataset);
    if (!absent.contains("/features")) read_features(in, file, dataset);
    if (!absent.contains("/probability")) {
        dataset.answer_names = in.texts("/probability", "class_names");
        dataset.probability = read_rows<float>(in, file, "/probability",
                                               {dataset.n_frames(), dataset.answer_names.size()});
    }
    read_columns({in, file}, absent, dataset);
    for (const Truth& truth : dataset.truth)
        if (truth.label >= dataset.class_names.size())
            throw InputError(format("{}: /label: {} beside {} class names; the file is damaged",
                                    file.string(), truth.label, dataset.class_names.size()));
    return dataset;
}

}  // namespace specula
