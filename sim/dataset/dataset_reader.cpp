#include "sim/dataset/dataset_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_layout.hpp"
#include "sim/dataset/truth_range.hpp"

namespace specula {

using namespace dataset_layout;

namespace {

double checked_version(const Hdf5File& in, const std::filesystem::path& file) {
    if (in.text("/", "format") != format_name)
        throw InputError(file.string() +
                         ": /@format: is not a dataset of this program; write one "
                         "with specula study, generate, simulate or import");
    const double version = in.number("/", "format_version");
    if (version < oldest_version || version > format_version || version != std::floor(version))
        throw InputError(
            format("{}: /@format_version = {}: this program reads versions {} to {}; "
                   "use the program that wrote it",
                   file.string(), version, oldest_version, format_version));
    return version;
}

}  // namespace

DatasetReader::DatasetReader(const std::filesystem::path& file)
    : file_(file), in_(Hdf5File::open(file)), version_(checked_version(in_, file)) {
    read_origin();
    read_forms();
}

void DatasetReader::fail(const std::string& problem) const {
    throw InputError(file_.string() + ": " + problem + "; the file is damaged");
}

double DatasetReader::bin_m(const std::string& object, const std::string& name) const {
    const double value = in_.number(object, name);
    if (const std::string problem = range_problem(possible_bin_m, value); !problem.empty())
        fail(format("{}@{} = {}: {}", object, name, value, problem));
    return value;
}

void DatasetReader::read_origin() {
    Origin& origin = form_.origin;
    origin.version = in_.text("/", "software_version");
    origin.condition = in_.text("/", "condition");
    origin.experiment = in_.text("/", "experiment_toml");
    origin.radar = in_.text("/", "radar");
    origin.bin_m = bin_m("/", "range_bin_m");
    const std::string seed = in_.text("/", "seed");
    const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), origin.seed);
    if (error != std::errc{} || end != seed.data() + seed.size()) fail("/@seed: is not a number");
    form_.class_names = in_.texts("/", "class_names");
    check_names("/@class_names", form_.class_names);
    if (version_ >= 3.0) origin.recipe = in_.text("/", "recipe");
    if (version_ < 2.0) {
        tables_ = tables_without(parted_names(left_out_in_version_1));
        return;
    }
    origin.source = in_.text("/", "source");
    if (in_.text("/", "sample_axis") == "range") form_.sample_axis = SampleAxis::range;
    tables_ = tables_without(parted_names(in_.text("/", "left_out")));
    if (version_ < 3.0) tables_.profile = false;
}

void DatasetReader::check_names(const std::string& attribute,
                                const std::vector<std::string>& names) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty()) fail(format("{}: name {} is empty", attribute, i));
        const auto first = std::find(names.begin(), names.end(), names[i]) - names.begin();
        if (static_cast<std::size_t>(first) < i)
            fail(format("{}: name {} = \"{}\": is the name of class {} too", attribute, i, names[i],
                        first));
    }
}

void DatasetReader::check_label_names() const {
    const std::vector<std::string> attributes = in_.attributes("/label");
    if (std::find(attributes.begin(), attributes.end(), "class_names") == attributes.end()) return;
    const std::vector<std::string> names = in_.texts("/label", "class_names");
    for (std::size_t i = 0; i < std::max(names.size(), form_.class_names.size()); ++i) {
        const auto name_of = [i](const std::vector<std::string>& list) {
            return i < list.size() ? format("\"{}\"", list[i]) : std::string("not there");
        };
        if (name_of(names) != name_of(form_.class_names))
            fail(format("/label@class_names: name {} is {}, and in /@class_names it is {}", i,
                        name_of(names), name_of(form_.class_names)));
    }
}

void DatasetReader::read_codes_form() {
    const auto shape = in_.shape("/adc");
    const auto possible = [](std::size_t n) { return n >= 1 && n <= most_per_axis; };
    if (shape.size() != 4 || !std::all_of(shape.begin() + 1, shape.end(), possible))
        fail("/adc: is not (frame, chirp, rx, sample)");
    form_.n_chirps = static_cast<int>(shape[1]);
    form_.n_rx = static_cast<int>(shape[2]);
    form_.n_samples = static_cast<int>(shape[3]);
    n_frames_ = shape[0];
    if (tables_.adc_quadrature && in_.shape("/adc_quadrature") != shape)
        fail("/adc_quadrature: has not the shape of /adc");
}

void DatasetReader::read_forms() {
    const bool has_rows = tables_.adc || tables_.profile || tables_.features;
    if (tables_.adc || !has_rows) read_codes_form();
    if (tables_.profile) {
        const auto shape = in_.shape("/profile");
        const bool possible = shape.size() == 3 && shape[1] >= 1 && shape[1] <= most_per_axis &&
                              shape[2] >= 1 && shape[2] <= most_per_axis;
        if (!possible || (tables_.adc && shape[1] != static_cast<std::size_t>(form_.n_rx)))
            fail("/profile: is not (frame, rx, bin)");
        form_.n_rx = static_cast<int>(shape[1]);
        form_.n_profile_bins = static_cast<int>(shape[2]);
        form_.profile_window = in_.text("/profile", "window");
        form_.profile_bin_m = bin_m("/profile", "bin_m");
        if (!tables_.adc) n_frames_ = shape[0];
    }
    if (tables_.features) {
        form_.feature_names = in_.texts("/features", "feature_names");
        if (!tables_.adc && !tables_.profile) n_frames_ = in_.shape("/features")[0];
    }
    if (tables_.probability) {
        form_.answer_names = in_.texts("/probability", "class_names");
        check_names("/probability@class_names", form_.answer_names);
    }
    check_label_names();
    form_.has_views = tables_.views;
    form_.unknown_truth = tables_.unknown_truth;
    const std::vector<std::string> groups = in_.groups();
    if (std::find(groups.begin(), groups.end(), "shard") == groups.end()) return;
    const auto count = [&](const char* name) {
        const double value = in_.number("/shard", name);
        if (!(value >= 0.0 && value < 0x1p53)) fail(format("/shard/@{}: is no count", name));
        return static_cast<std::size_t>(value);
    };
    shard_ = {count("first_session"), count("n_sessions"), count("n_sessions_in_all")};
}

template <typename T>
std::vector<T> DatasetReader::rows(const std::string& table, const FrameRange& range) const {
    const Hdf5Table in = in_.table(table);
    if (in.size()[0] != n_frames_)
        throw InputError(format("{}: a column {} of {} rows beside {} frames", file_.string(),
                                table, in.size()[0], n_frames_));
    return in.read_rows<T>(range.first, range.last - range.first);
}

template <typename T>
std::vector<T> DatasetReader::finite_rows(const std::string& table, std::size_t per_frame,
                                          const FrameRange& range) const {
    const TableShape shape{in_.shape(table)};
    if (shape.size[0] != n_frames_ || shape.values_per_row() != per_frame)
        fail(format("{}: is not one row of {} numbers per frame", table, per_frame));
    std::vector<T> values = rows<T>(table, range);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            fail(format("{}: row {} = {}: is not finite", table, range.first + i / per_frame,
                        values[i]));
    return values;
}

std::vector<Truth> DatasetReader::truth(const FrameRange& range) const {
    std::vector<Truth> frames(range.last - range.first);
    const auto fill = [&]<typename T>(const std::string& table, T Truth::*member) {
        const auto values = rows<T>(table, range);
        if (values.size() != frames.size()) fail(table + ": is not one number per frame");
        for (std::size_t i = 0; i < frames.size(); ++i) frames[i].*member = values[i];
    };
    fill("/label", &Truth::label);
    for (const IdColumn& id : id_columns) fill(id.name, id.member);
    if (tables_.views) fill(view_column.name, view_column.member);
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        if (!tables_.unknown_truth[i])
            fill(std::string("/truth/") + truth_columns[i].name, truth_columns[i].member);
    for (std::size_t i = 0; i < frames.size(); ++i) check_truth(frames[i], range.first + i);
    return frames;
}

void DatasetReader::check_truth(const Truth& frame, std::size_t row) const {
    if (frame.label >= form_.class_names.size())
        fail(format("/label: row {} = {}: is none of the {} classes", row, frame.label,
                    form_.class_names.size()));
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        if (tables_.unknown_truth[i]) continue;
        const double value = frame.*truth_columns[i].member;
        if (const std::string problem = truth_problem(i, value); !problem.empty())
            fail(format("/truth/{}: row {} = {}: {}", truth_columns[i].name, row, value, problem));
    }
}

Dataset DatasetReader::read(const FrameRange& range) const {
    Dataset frames = form_;
    if (tables_.adc) frames.adc = rows<std::int16_t>("/adc", range);
    if (tables_.adc_quadrature)
        frames.adc_quadrature = rows<std::int16_t>("/adc_quadrature", range);
    if (tables_.profile)
        frames.profile = finite_rows<float>("/profile", form_.profile_per_frame(), range);
    if (tables_.features)
        frames.features = finite_rows<double>("/features", form_.feature_names.size(), range);
    if (tables_.probability)
        frames.probability = finite_rows<float>("/probability", form_.answer_names.size(), range);
    frames.truth = truth(range);
    if (version_ >= 3.0) check_hashes(frames, range);
    return frames;
}

void DatasetReader::check_hashes(const Dataset& frames, const FrameRange& range) const {
    const auto stored = rows<std::uint64_t>("/frame_hash", range);
    FrameHash hash;
    for (std::size_t i = 0; i < stored.size(); ++i)
        if (hash.of(frames, i) != stored[i])
            fail(format("/frame_hash: does not fit frame {}", range.first + i));
}

std::vector<std::uint64_t> DatasetReader::frame_hashes(const FrameRange& range) const {
    if (version_ >= 3.0) return rows<std::uint64_t>("/frame_hash", range);
    const Dataset frames = read(range);
    std::vector<std::uint64_t> hashes;
    FrameHash hash;
    for (std::size_t i = 0; i < frames.n_frames(); ++i) hashes.push_back(hash.of(frames, i));
    return hashes;
}

FrameBlock DatasetReader::read_packed(const FrameRange& range) const {
    FrameBlock block;
    const auto read_chunks = [&](const std::string& table, PackedFrames& to) {
        const Hdf5Table in = in_.table(table);
        for (std::size_t row = range.first; row < range.last; ++row) {
            in.read_chunk(row, to.bytes);
            to.ends.push_back(to.bytes.size());
        }
    };
    if (tables_.adc) read_chunks("/adc", block.adc);
    if (tables_.adc_quadrature) read_chunks("/adc_quadrature", block.adc_quadrature);
    if (tables_.profile)
        block.profile = finite_rows<float>("/profile", form_.profile_per_frame(), range);
    if (tables_.features)
        block.features = finite_rows<double>("/features", form_.feature_names.size(), range);
    if (tables_.probability)
        block.probability = finite_rows<float>("/probability", form_.answer_names.size(), range);
    block.frame_hash = rows<std::uint64_t>("/frame_hash", range);
    block.truth = truth(range);
    return block;
}

Dataset read_dataset(const std::filesystem::path& file) {
    const DatasetReader in(file);
    return in.read({0, in.n_frames()});
}

}  // namespace specula
