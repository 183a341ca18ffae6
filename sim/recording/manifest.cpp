#include "sim/recording/manifest.hpp"

#include <algorithm>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double most_frames = 1e9;
constexpr double largest_id = 2147483647.0;

/// A truth column's key without its unit, and that unit; nothing for a plain number.
std::optional<Unit> unit_of(const TruthColumn& column) {
    const std::string unit = column.unit;
    if (unit == "m") return Unit::length;
    if (unit == "rad") return Unit::angle;
    if (unit == "dB") return Unit::ratio_db;
    return std::nullopt;
}

std::string stem_of(const TruthColumn& column) {
    const std::string name = column.name;
    return name.substr(0, name.rfind('_'));
}

void read_truth(Section& section, RecordingPart& part) {
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        const TruthColumn& column = truth_columns[i];
        if (const auto unit = unit_of(column)) {
            if (section.has_quantity(stem_of(column), *unit))
                part.truth[i] = section.quantity(stem_of(column), *unit, Range::any());
        } else if (section.has(column.name)) {
            part.truth[i] = section.number(column.name, Range::any());
        }
    }
}

std::int32_t read_id(Section& section, const std::string& key) {
    return section.count(key, Range::between(0, largest_id), 0);
}

RecordingPart read_part(Section section) {
    RecordingPart part;
    const auto frames = section.numbers("frames", 2, Range::between(0, most_frames));
    part.first = static_cast<std::size_t>(frames[0]);
    part.last = static_cast<std::size_t>(frames[1]);
    if (part.last < part.first)
        section.fail("frames", "ends before it begins", "give the first and the last frame");
    part.class_name = section.text("class");
    part.world = read_id(section, "world");
    part.sample = read_id(section, "sample");
    part.session = read_id(section, "session");
    if (section.has("view")) part.view = read_id(section, "view");
    read_truth(section, part);
    section.finish();
    return part;
}

void read_layout(Section section, RecordingManifest& manifest) {
    if (section.has("axes")) manifest.axes = section.texts("axes");
    for (const auto& [key, axis] :
         {std::pair{"recordings", "recording"}, std::pair{"frames", "frame"},
          std::pair{"chirps", "chirp"}, std::pair{"tx", "tx"}, std::pair{"rx", "rx"},
          std::pair{"samples", "sample"}})
        if (section.has(key))
            manifest.length[axis] =
                static_cast<std::size_t>(section.count(key, Range::between(1, most_frames)));
    manifest.member = section.text("member", "");
    if (section.has("packing"))
        manifest.packing = section.choice("packing", {"int16", "lvds_iq"}) == "lvds_iq"
                               ? Packing::lvds_iq
                               : Packing::int16;
    manifest.packets = section.flag("packets", false);
    manifest.wrapped = section.flag("wrapped", false);
    manifest.trust_axes = section.flag("trust_axes", false);
    if (section.has("features")) manifest.features = section.texts("features");
    section.finish();
}

/// Takes from a radar of the catalogue what a recording of it must be like.
void read_known_radar(Section& section, const Catalogue& catalogue, RecordingManifest& manifest) {
    manifest.radar = section.text("radar", manifest.radar);
    const auto known = catalogue.radar_names();
    const std::string extension = std::filesystem::path(manifest.radar).extension().string();
    const bool is_file = extension == ".toml" || extension == ".cfg";
    if (std::ranges::count(known, manifest.radar) == 0 && !is_file) return;
    const Radar radar = catalogue.radar(section, "radar");
    manifest.radar = radar.name;
    manifest.bin_m = radar.chirp.bin_m();
    manifest.length = {{"chirp", static_cast<std::size_t>(radar.chirps_per_frame)},
                       {"rx", radar.rx.size()},
                       {"sample", static_cast<std::size_t>(radar.chirp.n_samples)}};
}

void check_overlap(const Section& section, std::vector<RecordingPart> parts) {
    std::ranges::sort(parts, {}, &RecordingPart::first);
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (parts[i].first <= parts[i - 1].last)
            section.fail("part", format("frame {} belongs to two parts", parts[i].first),
                         "let each frame belong to one");
}

void check_distinct(const Section& section, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto first = std::ranges::find(names, names[i]) - names.begin();
        if (names[i].empty() || static_cast<std::size_t>(first) < i)
            section.fail("class_names",
                         names[i].empty() ? format("name {} is empty", i)
                                          : format("\"{}\" is there twice", names[i]),
                         "give each class a name of its own");
    }
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + "\"";
}

}  // namespace

RecordingManifest read_manifest(Section section, const Catalogue& catalogue) {
    RecordingManifest manifest;
    manifest.source = section.source();
    manifest.condition = section.text("condition", manifest.condition);
    read_known_radar(section, catalogue, manifest);
    manifest.bin_m =
        section.quantity("range_bin", Unit::length, Range::at_least(0.0), manifest.bin_m);
    if (section.choice("sample_axis", {"beat", "range"}, "beat") == "range")
        manifest.sample_axis = SampleAxis::range;
    if (section.has("class_names")) {
        manifest.class_names = section.texts("class_names");
        check_distinct(section, manifest.class_names);
    }
    if (auto layout = section.find_section("layout")) read_layout(*layout, manifest);
    if (auto labels = section.find_section("labels")) {
        for (const char* key : {"class", "world", "sample", "session", "view", "frame"})
            if (labels->has(key)) manifest.columns[key] = labels->text(key);
        labels->finish();
    }
    for (const Section& part : section.sections("part")) manifest.parts.push_back(read_part(part));
    check_overlap(section, manifest.parts);
    section.finish();
    return manifest;
}

std::string manifest_of(const Dataset& dataset, const std::string& layout) {
    std::string text =
        std::string(manifest_first_line) +
        format("condition = {}\nradar = {}\nrange_bin_m = {}\nsample_axis = {}\n",
               quoted(dataset.origin.condition), quoted(dataset.origin.radar), dataset.origin.bin_m,
               dataset.sample_axis == SampleAxis::range ? "\"range\"" : "\"beat\"");
    text += "class_names = [";
    for (std::size_t i = 0; i < dataset.class_names.size(); ++i)
        text += (i == 0 ? "" : ", ") + quoted(dataset.class_names[i]);
    text += "]\n";
    const auto key = [&](const Truth& truth) {
        return format("class = {}, world = {}, sample = {}, session = {}{}",
                      quoted(dataset.class_names.at(truth.label)), truth.world, truth.sample,
                      truth.session, dataset.has_views ? format(", view = {}", truth.view) : "");
    };
    text += "part = [\n";
    for (std::size_t first = 0; first < dataset.n_frames();) {
        std::size_t last = first;
        const std::string same = key(dataset.truth[first]);
        while (last + 1 < dataset.n_frames() && key(dataset.truth[last + 1]) == same) ++last;
        text += format("    {{frames = [{}, {}], {}}},\n", first, last, same);
        first = last + 1;
    }
    return text + "]\n" + layout;
}

}  // namespace specula
