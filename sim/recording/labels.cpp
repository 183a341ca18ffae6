#include "sim/recording/labels.hpp"

#include <algorithm>
#include <charconv>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t most_classes = 256;  // labels are bytes
constexpr const char* unlabelled = "unlabelled";

bool is_id(const std::string& text, std::int32_t& id) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, id);
    return result.ec == std::errc{} && result.ptr == end;
}

/// Whole numbers as they are; if there is anything else, all words in the order they come.
std::vector<std::int32_t> ids_of(const std::vector<std::string>& texts) {
    std::vector<std::int32_t> ids(texts.size());
    bool all_numbers = true;
    for (std::size_t i = 0; i < texts.size(); ++i) all_numbers &= is_id(texts[i], ids[i]);
    if (all_numbers) return ids;
    std::map<std::string, std::int32_t> numbered;
    for (std::size_t i = 0; i < texts.size(); ++i)
        ids[i] =
            numbered.emplace(texts[i], static_cast<std::int32_t>(numbered.size())).first->second;
    return ids;
}

/// A class by its name, or by its number among the names.
std::size_t class_index(const std::string& text, const std::vector<std::string>& names) {
    const auto found = std::ranges::find(names, text);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::int32_t index = -1;
    if (is_id(text, index) && index >= 0 && static_cast<std::size_t>(index) < names.size())
        return static_cast<std::size_t>(index);
    throw InputError(
        format("class \"{}\": is not among class_names; use {}", text, quoted_list(names)));
}

/// The text of every frame's class; empty where nothing names one.
std::vector<std::string> class_texts(const RecordingManifest& manifest, const LabelColumns& columns,
                                     std::size_t n_frames) {
    std::vector<std::string> texts(n_frames);
    if (const auto column = columns.find("class"); column != columns.end()) texts = column->second;
    for (const RecordingPart& part : manifest.parts)
        for (std::size_t i = part.first; i <= part.last; ++i) texts[i] = part.class_name;
    for (std::string& text : texts)
        if (text.empty()) text = unlabelled;
    return texts;
}

void apply_classes(const RecordingManifest& manifest, const LabelColumns& columns,
                   Dataset& dataset) {
    const auto texts = class_texts(manifest, columns, dataset.n_frames());
    dataset.class_names = manifest.class_names;
    const bool some_unlabelled = std::ranges::count(texts, unlabelled) > 0;
    for (const std::string& text : texts) {
        const bool is_new = std::ranges::count(dataset.class_names, text) == 0;
        if (is_new && (manifest.class_names.empty() || (some_unlabelled && text == unlabelled)))
            dataset.class_names.push_back(text);
        if (dataset.class_names.size() > most_classes)
            throw InputError(
                format("class: there are more than {}; is it the right column?", most_classes));
    }
    for (std::size_t i = 0; i < texts.size(); ++i)
        dataset.truth[i].label =
            static_cast<std::uint8_t>(class_index(texts[i], dataset.class_names));
}

void apply_parts(const RecordingManifest& manifest, Dataset& dataset) {
    dataset.unknown_truth.set();
    for (const RecordingPart& part : manifest.parts) {
        for (std::size_t i = part.first; i <= part.last; ++i) {
            Truth& truth = dataset.truth[i];
            truth.world = part.world;
            truth.sample = part.sample;
            truth.session = part.session;
            truth.view = part.view.value_or(0);
            for (std::size_t k = 0; k < truth_columns.size(); ++k)
                if (part.truth[k]) truth.*truth_columns[k].member = *part.truth[k];
        }
        dataset.has_views |= part.view.has_value();
    }
    // A column is known where every part knows it, and every frame is in one.
    std::size_t n_covered = 0;
    for (const RecordingPart& part : manifest.parts) n_covered += part.last - part.first + 1;
    for (std::size_t k = 0; k < truth_columns.size() && n_covered == dataset.n_frames(); ++k)
        dataset.unknown_truth[k] = !std::ranges::all_of(
            manifest.parts, [k](const RecordingPart& part) { return part.truth[k].has_value(); });
}

/// Numbers pairs (first, second) as they come.
void renumber(Dataset& dataset, std::int32_t Truth::*target, auto first, auto second) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> numbered;
    for (Truth& truth : dataset.truth)
        truth.*target = numbered
                            .emplace(std::pair{first(truth), second(truth)},
                                     static_cast<std::int32_t>(numbered.size()))
                            .first->second;
}

void part_pieces(Dataset& dataset) {
    std::map<std::int32_t, std::uint8_t> class_of;
    const bool two_classes = std::ranges::any_of(dataset.truth, [&](const Truth& truth) {
        return class_of.emplace(truth.sample, truth.label).first->second != truth.label;
    });
    if (two_classes)
        renumber(
            dataset, &Truth::sample,
            [](const Truth& t) { return static_cast<std::int32_t>(t.label); },
            [](const Truth& t) { return t.sample; });
}

void number_frames(Dataset& dataset) {
    std::map<std::int32_t, std::int32_t> next;
    for (Truth& truth : dataset.truth) truth.frame = next[truth.session]++;
}

}  // namespace

void apply_labels(const RecordingManifest& manifest, const LabelColumns& columns,
                  std::size_t n_recordings, Dataset& dataset) {
    const std::size_t n = dataset.n_frames();
    for (const RecordingPart& part : manifest.parts)
        if (part.last >= n)
            throw InputError(format("frames = [{}, {}]: the recording has {} frames; end at {}",
                                    part.first, part.last, n, n - 1));
    apply_classes(manifest, columns, dataset);
    apply_parts(manifest, dataset);
    const auto apply = [&](const char* key, std::int32_t Truth::*member) {
        const auto column = columns.find(key);
        if (column == columns.end()) return false;
        const auto ids = ids_of(column->second);
        for (std::size_t i = 0; i < n; ++i) dataset.truth[i].*member = ids[i];
        return true;
    };
    apply("world", &Truth::world);
    apply("sample", &Truth::sample);
    if (apply("view", &Truth::view)) dataset.has_views = true;
    part_pieces(dataset);
    const bool sessions_known = apply("session", &Truth::session) || !manifest.parts.empty();
    if (!sessions_known && n_recordings > 1)
        for (std::size_t i = 0; i < n; ++i)
            dataset.truth[i].session = static_cast<std::int32_t>(i / (n / n_recordings));
    else if (!sessions_known)
        renumber(
            dataset, &Truth::session, [](const Truth& t) { return t.sample; },
            [](const Truth& t) { return t.view; });
    if (!apply("frame", &Truth::frame)) number_frames(dataset);
}

}  // namespace specula
