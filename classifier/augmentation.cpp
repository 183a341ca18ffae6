#include "classifier/augmentation.hpp"

#include <charconv>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/kind.hpp"

namespace specula {

namespace {

constexpr double most_lsb = 32767.0, most_gain_db = 60.0, most_distance_m = 100.0;

/// A law for a number without unit that must be there.
Distribution law(Section& section, std::string_view key, Range range) {
    const std::string name(key);
    if (!section.has(name)) section.number(name, range);  // throws that it is missing
    return section.factor(name, range, {});
}

Distribution distance(Section& section) {
    return section.distribution("distance", Unit::length,
                                Range::between(-most_distance_m, most_distance_m));
}

const Range to_scatterer = Range::inside(0.0, most_distance_m);

}  // namespace

NoiseStep NoiseStep::read(Section& section) {
    return {law(section, main_key, Range::between(0.0, most_lsb))};
}
GainStep GainStep::read(Section& section) {
    return {
        section.distribution("gain", Unit::ratio_db, Range::between(-most_gain_db, most_gain_db))};
}
LeakageStep LeakageStep::read(Section& section) {
    return {law(section, main_key, Range::between(0.0, most_lsb)),
            section.distribution("range", Unit::length, to_scatterer, LeakageStep{}.range_m)};
}
ClutterStep ClutterStep::read(Section& section) {
    return {law(section, main_key, Range::between(0.0, most_lsb)),
            section.distribution("range", Unit::length, to_scatterer, Distribution(1.0))};
}
ShiftStep ShiftStep::read(Section& section) {
    return {distance(section)};
}
RangeStep RangeStep::read(Section& section) {
    return {distance(section)};
}

std::string_view kind_of(const AugmentStep& step) {
    return std::visit([](const auto& each) { return each.kind; }, step);
}

std::string_view unit_of(const AugmentStep& step) {
    const std::string_view key = std::visit([](const auto& each) { return each.main_key; }, step);
    return key == "gain_db" ? "dB" : key == "level_lsb" ? "LSB" : "m";
}

RadarView view_of(const Radar& radar) {
    const Receiver& receiver = radar.receiver;
    return {.bin_m = radar.chirp.bin_m(),
            .bin_hz = radar.chirp.sample_rate_hz / radar.chirp.n_samples,
            .start_hz = radar.chirp.frequency_hz(0),
            .first_pole_hz = receiver.high_pass_hz,
            .second_pole_hz = receiver.second_high_pass_hz < 0.0 ? receiver.high_pass_hz
                                                                 : receiver.second_high_pass_hz,
            .max_range_m = radar.chirp.max_range_m(),
            .n_samples = radar.chirp.n_samples,
            .n_rows = radar.chirps_per_frame * static_cast<int>(radar.rx.size())};
}

std::complex<double> high_pass_ratio(const RadarView& view, double from, double to) {
    if (!(to > 0.0)) return 0.0;
    if (!(view.bin_hz > 0.0) || !(from > 0.0)) return 1.0;
    const auto response = [&](double bin) {
        std::complex<double> left = 1.0;
        for (const double pole_hz : {view.first_pole_hz, view.second_pole_hz}) {
            if (!(pole_hz > 0.0)) continue;
            const std::complex<double> x(0.0, bin * view.bin_hz / pole_hz);
            left *= x / (1.0 + x);
        }
        return left;
    };
    return response(to) / response(from);
}

std::vector<AugmentStep> read_steps(Section& recipe) {
    std::vector<AugmentStep> steps;
    for (Section& section : recipe.sections("step")) {
        steps.push_back(read_kind<AugmentStep>(section, "kind"));
        section.finish();
    }
    if (steps.empty()) recipe.fail("step", "is missing", "add a [[step]] with a kind");
    return steps;
}

AugmentStep step_of(const std::string& text) {
    const std::string where = "--step " + text;
    const std::size_t equal = text.find('=');
    const std::string kind = text.substr(0, equal);
    const auto known = kinds_of<AugmentStep>();
    if (equal == std::string::npos || std::find(known.begin(), known.end(), kind) == known.end())
        throw InputError(format("{}: is no step; write {}, then = and a number or LOW:HIGH", where,
                                quoted_list(known)));
    const std::string law = text.substr(equal + 1);
    const std::size_t colon = law.find(':');
    const auto check_number = [&](const std::string& word) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size())
            throw InputError(format("{}: \"{}\" is no number; write {}=1.5 or {}=-1:1", where, word,
                                    kind, kind));
    };
    std::string_view key;
    [&]<typename... Steps>(std::type_identity<std::variant<Steps...>>) {
        ((Steps::kind == kind ? void(key = Steps::main_key) : void()), ...);
    }(std::type_identity<AugmentStep>{});
    std::string value = law;
    if (colon == std::string::npos) {
        check_number(law);
    } else {
        const std::string low = law.substr(0, colon), high = law.substr(colon + 1);
        check_number(low);
        check_number(high);
        value = format("{{ uniform = [{}, {}] }}", low, high);
    }
    Section section = Section::parse(format("kind = \"{}\"\n{} = {}\n", kind, key, value), where);
    try {
        return read_kind<AugmentStep>(section, "kind");
    } catch (const InputError& error) {
        // Nobody but this function knows of lines.
        const std::string told = error.what(), place = where + ":2:";
        if (told.rfind(place, 0) != 0) throw;
        throw InputError(where + ":" + told.substr(place.size()));
    }
}

}  // namespace specula
