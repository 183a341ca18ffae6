#include "sim/dataset/dataset_writer.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/dataset/dataset_layout.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "sim/dataset/table_stream.hpp"

namespace specula {

using namespace dataset_layout;

namespace {

void write_origin(Hdf5File& out, const DatasetHead& head) {
    const Origin& origin = head.form.origin;
    out.set_text("/", "format", format_name);
    out.set_number("/", "format_version", format_version);
    out.set_text("/", "software", "specula");
    out.set_text("/", "software_version", origin.version);
    out.set_text("/", "condition", origin.condition);
    out.set_text("/", "experiment_toml", origin.experiment);
    out.set_text("/", "recipe", origin.recipe);
    out.set_text("/", "seed", std::to_string(origin.seed));
    out.set_text("/", "radar", origin.radar);
    out.set_number("/", "range_bin_m", origin.bin_m);
    out.set_texts("/", "class_names", head.form.class_names);
    out.set_text("/", "source", origin.source);
    out.set_text("/", "sample_axis", head.form.sample_axis == SampleAxis::range ? "range" : "beat");
    out.set_text("/", "left_out", left_out(head.tables));
}

void write_shard(Hdf5File& out, const SessionSpan& shard) {
    out.create_group("/shard");
    out.set_number("/shard", "first_session", static_cast<double>(shard.first));
    out.set_number("/shard", "n_sessions", static_cast<double>(shard.count));
    out.set_number("/shard", "n_sessions_in_all", static_cast<double>(shard.n_in_all));
}

std::size_t axis(int n) {
    return static_cast<std::size_t>(n);
}

Hdf5Table create_codes(Hdf5File& out, const DatasetHead& head, const std::string& name) {
    const Dataset& form = head.form;
    Hdf5Table table = out.create_table<std::int16_t>(
        name, {{head.n_frames, axis(form.n_chirps), axis(form.n_rx), axis(form.n_samples)}, 1});
    out.set_text(name, "units", "LSB");
    out.set_texts(name, "axis_labels", {"frame", "chirp", "rx", "sample"});
    return table;
}

TableStream<float> create_profile(Hdf5File& out, const DatasetHead& head) {
    const Dataset& form = head.form;
    TableStream<float> table(out.create_table<float>(
        "/profile", {{head.n_frames, axis(form.n_rx), axis(form.n_profile_bins)}, profile_rows}));
    out.set_text("/profile", "units", "LSB");
    out.set_texts("/profile", "axis_labels", {"frame", "rx", "bin"});
    out.set_text("/profile", "window", form.profile_window);
    out.set_number("/profile", "bin_m", form.profile_bin_m);
    return table;
}

}  // namespace

/// A column of Truth on its way into the file.
template <typename T>
struct ColumnStream {
    T Truth::*member;
    TableStream<T> rows;

    void add(std::span<const Truth> frames) {
        std::vector<T> values;
        values.reserve(frames.size());
        for (const Truth& frame : frames) values.push_back(frame.*member);
        rows.add(values);
    }
};

/// The open file, table by table.
class DatasetWriter::Streams {
  public:
    Streams(const std::filesystem::path& file, const DatasetHead& head)
        : n_frames_(head.n_frames), out_(Hdf5File::create(file)) {
        SPECULA_EXPECT(head.form.feature_names.size() <= most_features);
        write_origin(out_, head);
        if (head.shard) write_shard(out_, *head.shard);
        create_rows(head);
        label_.push_back({&Truth::label, column<std::uint8_t>("/label")});
        out_.set_texts("/label", "class_names", head.form.class_names);
        hash_.emplace_back(column<std::uint64_t>("/frame_hash"));
        out_.create_group("/group");
        for (const IdColumn& id : id_columns) create_ids(id);
        if (head.tables.views) create_ids(view_column);
        out_.create_group("/truth");
        for (std::size_t i = 0; i < truth_columns.size(); ++i)
            if (!head.tables.unknown_truth[i]) create_truth(truth_columns[i]);
    }

    /// Frames [first, last) of a block, all in the same chunk of every table but the codes.
    void add(const FrameBlock& block, std::size_t first, std::size_t last) {
        for (std::size_t frame = first; frame < last; ++frame, ++row_) {
            if (!adc_.empty()) adc_[0].write_chunk(row_, block.adc.chunk(frame));
            if (adc_.size() > 1) adc_[1].write_chunk(row_, block.adc_quadrature.chunk(frame));
        }
        const auto add_rows = [&](auto& streams, const auto& table) {
            const std::size_t per_frame = table.size() / block.n_frames();
            for (auto& stream : streams)
                stream.add(std::span(table).subspan(first * per_frame, (last - first) * per_frame));
        };
        add_rows(profile_, block.profile);
        add_rows(features_, block.features);
        add_rows(probability_, block.probability);
        add_rows(hash_, block.frame_hash);
        const auto truth = std::span(block.truth).subspan(first, last - first);
        for (auto& stream : label_) stream.add(truth);
        for (auto& stream : ids_) stream.add(truth);
        for (auto& stream : truth_) stream.add(truth);
        fingerprint_.add(std::span(block.frame_hash).subspan(first, last - first));
    }

    /// Frames from the next one on that are in the same chunks as it.
    std::size_t until_boundary() const { return profile_rows - row_ % profile_rows; }

    void add_column(const DatasetWriter::FurtherColumn& column, const std::vector<double>& values) {
        SPECULA_EXPECT(values.size() == n_frames_);
        make_group(column.name.substr(0, column.name.rfind('/')));
        out_.write(column.name, {n_frames_}, column_rows, values);
        out_.set_text(column.name, "long_name", column.meaning);
        out_.set_text(column.name, "units", column.unit);
    }

    void set_group_text(const std::string& group, const std::string& name, const std::string& text) {
        make_group(group);
        out_.set_text(group, name, text);
    }

    void finish() {
        SPECULA_EXPECT(row_ == n_frames_);
        const auto finish_all = [](auto& streams) {
            for (auto& stream : streams) stream.flush();
            streams.clear();
        };
        const auto finish_columns = [](auto& columns) {
            for (auto& column : columns) column.rows.flush();
            columns.clear();
        };
        adc_.clear();
        finish_all(profile_);
        finish_all(features_);
        finish_all(probability_);
        finish_all(hash_);
        finish_columns(label_);
        finish_columns(ids_);
        finish_columns(truth_);
    }
    Hdf5File& file() { return out_; }
    std::string fingerprint() { return fingerprint_.text(); }

  private:
    template <typename T>
    TableStream<T> column(const std::string& name) {
        return TableStream<T>(out_.create_table<T>(name, {{n_frames_}, column_rows}));
    }
    void create_rows(const DatasetHead& head) {
        const Dataset& form = head.form;
        if (head.tables.adc) adc_.push_back(create_codes(out_, head, "/adc"));
        if (head.tables.adc_quadrature) adc_.push_back(create_codes(out_, head, "/adc_quadrature"));
        if (head.tables.profile) profile_.push_back(create_profile(out_, head));
        if (head.tables.features) {
            features_.emplace_back(out_.create_table<double>(
                "/features", {{n_frames_, form.feature_names.size()}, feature_rows}));
            out_.set_texts("/features", "feature_names", form.feature_names);
        }
        if (head.tables.probability) {
            probability_.emplace_back(out_.create_table<float>(
                "/probability", {{n_frames_, form.answer_names.size()}, feature_rows}));
            out_.set_texts("/probability", "class_names", form.answer_names);
        }
    }
    void make_group(const std::string& name) {
        if (std::find(groups_.begin(), groups_.end(), name) != groups_.end()) return;
        out_.create_group(name);
        groups_.push_back(name);
    }
    void create_ids(const IdColumn& id) {
        ids_.push_back({id.member, column<std::int32_t>(id.name)});
        out_.set_text(id.name, "long_name", id.meaning);
    }
    void create_truth(const TruthColumn& truth) {
        const std::string name = std::string("/truth/") + truth.name;
        truth_.push_back({truth.member, column<double>(name)});
        out_.set_text(name, "long_name", truth.meaning);
        out_.set_text(name, "units", truth.unit);
    }

    std::size_t n_frames_;
    std::size_t row_ = 0;
    Hdf5File out_;                // before its tables, which are closed first
    std::vector<Hdf5Table> adc_;  ///< codes and their quadrature; none where none are stored
    std::vector<TableStream<float>> profile_;  ///< one or none, as the others
    std::vector<TableStream<double>> features_;
    std::vector<TableStream<float>> probability_;
    std::vector<TableStream<std::uint64_t>> hash_;
    std::vector<ColumnStream<std::uint8_t>> label_;
    std::vector<ColumnStream<std::int32_t>> ids_;
    std::vector<ColumnStream<double>> truth_;
    std::vector<std::string> groups_;  ///< made besides those of the format
    Fingerprint fingerprint_;
};

DatasetWriter::DatasetWriter(const std::filesystem::path& file, const DatasetHead& head)
    : streams_(std::make_unique<Streams>(file, head)) {}

DatasetWriter::~DatasetWriter() = default;

void DatasetWriter::append(const FrameBlock& block) {
    for (std::size_t first = 0; first < block.n_frames();) {
        const std::size_t last = std::min(block.n_frames(), first + streams_->until_boundary());
        streams_->add(block, first, last);
        first = last;
    }
}

void DatasetWriter::add_column(const FurtherColumn& column, const std::vector<double>& values) {
    streams_->add_column(column, values);
}

void DatasetWriter::set_group_text(const std::string& group, const std::string& name,
                                   const std::string& text) {
    streams_->set_group_text(group, name, text);
}

std::string DatasetWriter::publish() {
    streams_->finish();
    streams_->file().publish();
    return streams_->fingerprint();
}

std::string DatasetWriter::publish_new() {
    streams_->finish();
    streams_->file().publish_new();
    return streams_->fingerprint();
}

void write_dataset(const std::filesystem::path& file, const Dataset& dataset) {
    constexpr std::size_t frames_at_once = 1024;
    DatasetWriter out(file, {.form = dataset,
                             .tables = tables_of(dataset),
                             .n_frames = dataset.n_frames(),
                             .shard = {}});
    for (std::size_t first = 0; first < dataset.n_frames(); first += frames_at_once)
        out.append(
            pack_frames(dataset, {first, std::min(first + frames_at_once, dataset.n_frames())}));
    out.publish();
}

}  // namespace specula
