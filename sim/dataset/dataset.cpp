#include "sim/dataset/dataset.hpp"

#include <algorithm>
#include <charconv>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/hdf5_file.hpp"

namespace specula {

namespace {

constexpr const char* format_name = "specula-dataset";
constexpr int format_version = 1;
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

template <typename T>
void fill_column(const Hdf5File& in, const std::string& name, T Truth::*member,
                 std::vector<Truth>& truth) {
    const auto values = in.read<T>(name);
    if (values.size() != truth.size())
        throw InputError(format("a column {} of {} rows beside {} frames", name, values.size(),
                                truth.size()));
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
}

Origin read_origin(const Hdf5File& in, const std::filesystem::path& file) {
    if (in.text("/", "format") != format_name)
        throw InputError(file.string() + ": /@format: is not a dataset of this program; "
                                         "write one with specula study or specula simulate");
    if (const double version = in.number("/", "format_version"); version != format_version)
        throw InputError(format("{}: /@format_version = {}: this program reads version {}; use the "
                                "program that wrote it",
                                file.string(), version, format_version));
    Origin origin;
    origin.version = in.text("/", "software_version");
    origin.condition = in.text("/", "condition");
    origin.experiment = in.text("/", "experiment_toml");
    origin.radar = in.text("/", "radar");
    origin.bin_m = in.number("/", "range_bin_m");
    const std::string seed = in.text("/", "seed");
    const auto [end, error] =
        std::from_chars(seed.data(), seed.data() + seed.size(), origin.seed);
    if (error != std::errc{} || end != seed.data() + seed.size())
        throw InputError(file.string() + ": /@seed: is not a number; the file is damaged");
    return origin;
}

}  // namespace

void write_dataset(const std::filesystem::path& file, const Dataset& dataset) {
    Hdf5File out = Hdf5File::create(file);
    write_origin(out, dataset);
    const std::size_t n = dataset.n_frames();
    out.write("/adc",
              {n, static_cast<std::size_t>(dataset.n_chirps),
               static_cast<std::size_t>(dataset.n_rx), static_cast<std::size_t>(dataset.n_samples)},
              1, dataset.adc);
    out.set_text("/adc", "units", "LSB");
    out.set_texts("/adc", "axis_labels", {"frame", "chirp", "rx", "sample"});
    out.write("/label", {n}, column_rows, column_of(dataset.truth, &Truth::label));
    out.set_texts("/label", "class_names", dataset.class_names);

    out.create_group("/group");
    for (const auto& column : id_columns) {
        const std::string name = std::string("/group/") + column.name;
        out.write(name, {n}, column_rows, column_of(dataset.truth, column.member));
        out.set_text(name, "long_name", column.meaning);
    }
    out.create_group("/truth");
    for (const TruthColumn& column : truth_columns) {
        const std::string name = std::string("/truth/") + column.name;
        out.write(name, {n}, column_rows, column_of(dataset.truth, column.member));
        out.set_text(name, "units", column.unit);
        out.set_text(name, "long_name", column.meaning);
    }
    out.publish();
}

Dataset read_dataset(const std::filesystem::path& file) {
    const Hdf5File in = Hdf5File::open(file);
    Dataset dataset;
    dataset.origin = read_origin(in, file);
    dataset.class_names = in.texts("/", "class_names");
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
    try {
        fill_column(in, "/label", &Truth::label, dataset.truth);
        for (const auto& column : id_columns)
            fill_column(in, std::string("/group/") + column.name, column.member, dataset.truth);
        for (const TruthColumn& column : truth_columns)
            fill_column(in, std::string("/truth/") + column.name, column.member, dataset.truth);
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", file.string(), error.what()));
    }
    for (const Truth& truth : dataset.truth)
        if (truth.label >= dataset.class_names.size())
            throw InputError(format("{}: /label: {} beside {} class names; the file is damaged",
                                    file.string(), truth.label, dataset.class_names.size()));
    return dataset;
}

}  // namespace specula
