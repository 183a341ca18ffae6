#include "sim/recording/import_tables.hpp"

#include <algorithm>

#include "sim/core/document.hpp"

namespace specula {

namespace {

constexpr std::size_t most_features = 4096;

std::size_t frame_jumps(const UartStream& stream) {
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < stream.frames.size(); ++i)
        if (stream.frames[i].number != stream.frames[i - 1].number + 1) ++jumps;
    return jumps;
}

std::vector<std::string> notes_on(const UartStream& stream, std::size_t n_without_profile) {
    std::vector<std::string> notes;
    if (!stream.gaps.empty()) {
        std::size_t bytes = 0;
        for (const UartGap& gap : stream.gaps) bytes += gap.bytes;
        notes.push_back(
            format("{} bytes in {} places belong to no sound packet; the first, at byte "
                   "{}: {}",
                   bytes, stream.gaps.size(), stream.gaps[0].offset, stream.gaps[0].reason));
    }
    if (const std::size_t jumps = frame_jumps(stream); jumps > 0)
        notes.push_back(
            format("frame numbers do not count on in {} places: packets were lost, or the sensor "
                   "was started again",
                   jumps));
    if (n_without_profile > 0)
        notes.push_back(
            format("{} packets have no range profile and are left out", n_without_profile));
    return notes;
}

void check_alike(const UartFrame& frame, const UartFrame& first) {
    if (frame.profile.size() != first.profile.size())
        fail_at(frame.offset,
                format("a range profile of {} bins after one of {}", frame.profile.size(),
                       first.profile.size()),
                "part the recording where the configuration changes");
    if (frame.probability.size() != first.probability.size())
        fail_at(frame.offset,
                format("an answer over {} classes after one over {}", frame.probability.size(),
                       first.probability.size()),
                "part the recording where the model changes");
}

std::size_t column_index(const CsvRows& table, const std::string& name) {
    const auto found = std::ranges::find(table.columns, name);
    if (found == table.columns.end())
        fail_at(0, format("no column is called \"{}\"", name), "use " + quoted_list(table.columns));
    return static_cast<std::size_t>(found - table.columns.begin());
}

/// Label key -> column.
std::map<std::string, std::size_t> label_columns(const CsvRows& table,
                                                 const RecordingManifest& manifest) {
    std::map<std::string, std::size_t> columns;
    for (const auto& [key, name] : manifest.columns) columns[key] = column_index(table, name);
    for (const std::string key : {"class", "world", "sample", "session", "view", "frame"})
        if (manifest.columns.empty() && std::ranges::count(table.columns, key) > 0)
            columns[key] = column_index(table, key);
    return columns;
}

std::vector<std::size_t> feature_columns(const CsvRows& table, const RecordingManifest& manifest,
                                         const std::map<std::string, std::size_t>& labels) {
    std::vector<std::size_t> columns;
    for (const std::string& name : manifest.features) columns.push_back(column_index(table, name));
    for (std::size_t k = 0; k < table.columns.size() && manifest.features.empty(); ++k)
        if (std::ranges::none_of(labels, [k](const auto& label) { return label.second == k; }))
            columns.push_back(k);
    if (columns.empty() || columns.size() > most_features)
        fail_at(0, format("{} columns of features", columns.size()),
                format("1 to {} are possible; name them in [layout] features", most_features));
    return columns;
}

}  // namespace

std::vector<std::string> take_uart(const UartStream& stream, Dataset& dataset) {
    const UartFrame* first = nullptr;
    std::size_t n_without_profile = 0;
    for (const UartFrame& frame : stream.frames) {
        if (frame.profile.empty()) {
            ++n_without_profile;
            continue;
        }
        if (first == nullptr) first = &frame;
        check_alike(frame, *first);
        for (const std::uint32_t bin : frame.profile)
            dataset.features.push_back(static_cast<double>(bin));
        dataset.probability.insert(dataset.probability.end(), frame.probability.begin(),
                                   frame.probability.end());
        dataset.truth.emplace_back().frame = static_cast<std::int32_t>(frame.number);
    }
    if (first == nullptr)
        throw InputError(
            format("byte 0: of {} packets none has a range profile (TLV 302 or 303); "
                   "switch it on with guiMonitor, and is this a UART stream?",
                   stream.frames.size()));
    for (std::size_t k = 0; k < first->profile.size(); ++k)
        dataset.feature_names.push_back(format("bin {}", k));
    for (std::size_t k = 0; k < first->probability.size(); ++k)
        dataset.answer_names.push_back(format("class {}", k));
    return notes_on(stream, n_without_profile);
}

std::vector<std::string> frame_numbers(const Dataset& dataset) {
    std::vector<std::string> numbers;
    for (const Truth& truth : dataset.truth) numbers.push_back(std::to_string(truth.frame));
    return numbers;
}

LabelColumns take_csv(const CsvRows& table, const RecordingManifest& manifest, Dataset& dataset) {
    const auto labels = label_columns(table, manifest);
    const auto features = feature_columns(table, manifest, labels);
    for (const std::size_t k : features) dataset.feature_names.push_back(table.columns[k]);
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        for (const std::size_t k : features)
            dataset.features.push_back(
                csv_number(table.rows[i][k], table.columns[k], table.offset[i]));
    dataset.truth.resize(table.rows.size());
    LabelColumns columns;
    for (const auto& [key, k] : labels)
        for (const auto& row : table.rows) columns[key].push_back(row[k]);
    return columns;
}

}  // namespace specula
