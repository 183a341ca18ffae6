#include "tools/validate/comparison.hpp"

#include <cmath>
#include <limits>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Levels in range profiles below this are the rounding of windows and sums.
constexpr double profile_floor_db = -150.0;

QuantityValue shown(Complex value, bool as_real) {
    if (as_real && value.imag() == 0.0) return value.real();
    return value;
}

std::string element(const std::string& name, std::size_t i) {
    return format("{}[{}]", name, i);
}

}  // namespace

double Comparison::tolerance(const std::string& key) const {
    return point_.tolerance.number(key, Range::at_least(0.0));
}

void Comparison::add(Quantity quantity) {
    quantity.judged = quantity.judged && judged_;
    quantities_.push_back(std::move(quantity));
}

void Comparison::absolute(const std::string& name, Complex computed, const std::string& key) {
    if (!wants(name)) return;
    const Complex expected = point_.expect.complex(name);
    const bool as_real = point_.expect.is_number(name);
    add({name, shown(computed, as_real), shown(expected, as_real),
         absolute_error({computed, expected}), tolerance(key), ""});
}

void Comparison::relative(const std::string& name, Complex computed, const std::string& key) {
    if (!wants(name)) return;
    const Complex expected = point_.expect.complex(name);
    const bool as_real = point_.expect.is_number(name);
    add({name, shown(computed, as_real), shown(expected, as_real),
         relative_error({computed, expected}), tolerance(key), "relative"});
}

void Comparison::level(const std::string& name, double computed_db, const std::string& key) {
    if (wants(name)) within(name, computed_db, {tolerance(key), "dB"});
}

void Comparison::within(const std::string& name, double computed, const Allowed& allowed) {
    if (wants(name)) beside(name, {computed, point_.expect.number(name)}, allowed);
}

void Comparison::beside(const std::string& name, const NumberPair& values, const Allowed& allowed) {
    const double error = absolute_error({values.computed, values.expected});
    add({name, values.computed, values.expected, error, allowed.error, allowed.unit});
}

void Comparison::same(const std::string& name, double computed) {
    within(name, computed, {0.0, ""});
}

void Comparison::same_flag(const std::string& name, bool computed) {
    if (!wants(name)) return;
    const bool expected = point_.expect.flag(name);
    add({name, computed, expected, computed == expected ? 0.0 : 1.0, 0.0, ""});
}

void Comparison::wrapped(const std::string& name, const Cyclic& computed, const std::string& key) {
    if (!wants(name)) return;
    const double expected = point_.expect.number(name);
    const double error = wrapped_error({computed.value, expected}, computed.turn);
    add({name, computed.value, expected, relative_error({expected + error, expected}),
         tolerance(key), "relative"});
}

std::vector<double> Comparison::expected_list(const std::string& name, std::size_t n) {
    std::vector<double> expected = point_.expect.numbers(name);
    if (expected.size() == n) return expected;
    add({name + " (length)", static_cast<double>(n), static_cast<double>(expected.size()), infinite,
         0.0, ""});
    return {};
}

void Comparison::absolute(const std::string& name, std::span<const double> computed,
                          const std::string& key, const std::string& unit) {
    if (!wants(name)) return;
    const auto expected = expected_list(name, computed.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        beside(element(name, i), {computed[i], expected[i]}, {tolerance(key), unit});
}

void Comparison::levels(const std::string& name, std::span<const double> computed_db,
                        const LevelTolerance& allowed) {
    if (!wants(name)) return;
    const auto expected = expected_list(name, computed_db.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const bool high = expected[i] > allowed.split_db;
        const bool judged = high || !allowed.below.empty();
        add({element(name, i), computed_db[i], expected[i],
             level_error_db({computed_db[i], expected[i]}, profile_floor_db),
             judged ? tolerance(high ? allowed.above : allowed.below) : infinite, "dB", judged});
    }
}

void Comparison::show(const std::string& name, const std::string& how,
                      std::span<const double> computed, const std::string& unit) {
    if (!wants(name)) return;
    const auto expected = point_.expect.numbers(name);
    for (std::size_t i = 0; i < std::min(expected.size(), computed.size()); ++i)
        add({element(format("{} ({})", name, how), i), computed[i], expected[i],
             absolute_error({computed[i], expected[i]}), infinite, unit, false});
}

void Comparison::show_angle(const std::string& name, const NumberPair& angles_deg) {
    add({name, angles_deg.computed, angles_deg.expected, wrapped_error(angles_deg, 360.0), infinite,
         "deg", false});
}

void Comparison::phases(const std::string& name, std::span<const double> computed_deg,
                        double tolerance_deg) {
    if (!wants(name)) return;
    const auto expected = expected_list(name, computed_deg.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        add({element(name, i), computed_deg[i], expected[i],
             wrapped_error({computed_deg[i], expected[i]}, 360.0), tolerance_deg, "deg"});
}

void Comparison::whole(const PartNames& names, std::span<const Complex> computed,
                       const std::string& key) {
    double error = 0.0, sum = 0.0, found = 0.0;
    std::string compared;
    const auto add_part = [&](const std::string& name, auto part) {
        if (!wants(name)) return;
        compared += (compared.empty() ? "norm of " : " and ") + name;
        const auto expected = expected_list(name, computed.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            error += std::pow(part(computed[i]) - expected[i], 2);
            sum += expected[i] * expected[i];
            found += std::pow(part(computed[i]), 2);
        }
    };
    add_part(names.real, [](Complex h) { return h.real(); });
    add_part(names.imaginary, [](Complex h) { return h.imag(); });
    if (compared.empty()) return;
    add({compared, std::sqrt(found), std::sqrt(sum), std::sqrt(error / (sum > 0.0 ? sum : 1.0)),
         tolerance(key), "relative"});
}

void Comparison::power(const PowerNames& names, const Power& computed, const std::string& key) {
    const double level_db = power_db(computed.value);
    if (wants(names.power)) {
        const double expected = point_.expect.number(names.power, Range::at_least(0.0));
        add({names.power, computed.value, expected,
             level_error_db({level_db, power_db(expected)}, computed.floor_db), tolerance(key),
             "dB"});
    }
    if (!wants(names.level)) return;
    const double expected_db = point_.expect.number(names.level);
    add({names.level, level_db, expected_db,
         level_error_db({level_db, expected_db}, computed.floor_db), tolerance(key), "dB"});
}

void Comparison::channel(const std::string& prefix, Complex h, const ChannelTolerance& allowed) {
    const std::string name = prefix + "h";
    if (wants(name)) {
        const Complex expected = point_.expect.complex(name);
        add({name + " (level)", h, expected, amplitude_error_db({h, expected}),
             tolerance(allowed.level), "dB"});
        add({name + " (phase)", h, expected,
             wrapped_error({phase_deg(h), phase_deg(expected)}, 360.0), tolerance(allowed.phase),
             "deg"});
    }
    level(prefix + "abs_db", amplitude_db(h), allowed.level);
    const std::string angle = prefix + "phase_deg";
    if (!wants(angle)) return;
    const double expected = point_.expect.number(angle);
    add({angle, phase_deg(h), expected, wrapped_error({phase_deg(h), expected}, 360.0),
         tolerance(allowed.phase), "deg"});
}

std::vector<Quantity> Comparison::finish() const {
    point_.inp.describe({"name", "title", "label", "comment", "note", "source"});
    const auto names = [](const std::vector<std::string>& left, const char* prefix) {
        std::string text;
        for (const std::string& name : left) text += (text.empty() ? "" : ", ") + (prefix + name);
        return text;
    };
    if (const auto left = point_.inp.unread(); !left.empty())
        throw NotComputable(format("does not know {}", names(left, "inp.")));
    if (const auto left = point_.expect.unread(); !left.empty())
        throw NotComputable(format("does not compute {}", names(left, "expect.")));
    return quantities_;
}

}  // namespace specula
