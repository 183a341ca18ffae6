#include "tools/validate/comparison.hpp"

#include <cmath>
#include <limits>

#include "sim/core/format.hpp"
#include "tools/validate/compare.hpp"

namespace specula {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Levels in range profiles below this are the rounding of windows and sums (PHYSICS.md knows none).
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
         absolute_error(computed, expected), tolerance(key), ""});
}

void Comparison::relative(const std::string& name, Complex computed, const std::string& key) {
    if (!wants(name)) return;
    const Complex expected = point_.expect.complex(name);
    const bool as_real = point_.expect.is_number(name);
    add({name, shown(computed, as_real), shown(expected, as_real),
         relative_error(computed, expected), tolerance(key), "relative"});
}

void Comparison::level(const std::string& name, double computed_db, const std::string& key) {
    if (wants(name)) within(name, computed_db, tolerance(key), "dB");
}

void Comparison::within(const std::string& name, double computed, double tolerance,
                        const std::string& unit) {
    if (!wants(name)) return;
    const double expected = point_.expect.number(name);
    add({name, computed, expected, absolute_error(computed, expected), tolerance, unit});
}

void Comparison::exact(const std::string& name, double computed) {
    within(name, computed, 0.0, "");
}

void Comparison::exact(const std::string& name, bool computed) {
    if (!wants(name)) return;
    const bool expected = point_.expect.flag(name);
    add({name, computed, expected, computed == expected ? 0.0 : 1.0, 0.0, ""});
}

void Comparison::phase(const std::string& name, double computed_deg, double tolerance_deg) {
    if (!wants(name)) return;
    const double expected = point_.expect.number(name);
    add({name, computed_deg, expected, phase_error_deg(computed_deg, expected), tolerance_deg,
         "deg"});
}

void Comparison::wrapped(const std::string& name, double computed, double turn,
                         const std::string& key) {
    if (!wants(name)) return;
    const double expected = point_.expect.number(name);
    const double error = std::abs(std::remainder(computed - expected, turn));
    add({name, computed, expected, relative_error(expected + error, expected), tolerance(key),
         "relative"});
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
        add({element(name, i), computed[i], expected[i], absolute_error(computed[i], expected[i]),
             tolerance(key), unit});
}

void Comparison::levels(const std::string& name, std::span<const double> computed_db,
                        const LevelTolerance& allowed) {
    if (!wants(name)) return;
    const auto expected = expected_list(name, computed_db.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const bool high = expected[i] > allowed.split_db;
        const bool judged = high || !allowed.below.empty();
        add({element(name, i), computed_db[i], expected[i],
             level_error_db(computed_db[i], expected[i], profile_floor_db),
             judged ? tolerance(high ? allowed.above : allowed.below) : infinite, "dB", judged});
    }
}

void Comparison::phases(const std::string& name, std::span<const double> computed_deg,
                        double tolerance_deg) {
    if (!wants(name)) return;
    const auto expected = expected_list(name, computed_deg.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        add({element(name, i), computed_deg[i], expected[i],
             phase_error_deg(computed_deg[i], expected[i]), tolerance_deg, "deg"});
}

void Comparison::whole(const std::string& real_name, const std::string& imaginary_name,
                       std::span<const Complex> computed, const std::string& key) {
    const bool real = wants(real_name), imaginary = wants(imaginary_name);
    if (!real && !imaginary) return;
    double error = 0.0, sum = 0.0, found = 0.0;
    const auto add_part = [&](const std::string& name, auto part) {
        const auto expected = expected_list(name, computed.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            error += std::pow(part(computed[i]) - expected[i], 2);
            sum += expected[i] * expected[i];
            found += std::pow(part(computed[i]), 2);
        }
    };
    if (real) add_part(real_name, [](Complex h) { return h.real(); });
    if (imaginary) add_part(imaginary_name, [](Complex h) { return h.imag(); });
    const double scale = sum > 0.0 ? sum : 1.0;
    add({format("norm of {}", real && imaginary ? real_name + " and " + imaginary_name
                              : real            ? real_name
                                                : imaginary_name),
         std::sqrt(found), std::sqrt(sum), std::sqrt(error / scale), tolerance(key), "relative"});
}

void Comparison::channel(const std::string& prefix, Complex h) {
    if (wants(prefix + "h")) {
        const Complex expected = point_.expect.complex(prefix + "h");
        add({prefix + "h (level)", h, expected, amplitude_error_db(h, expected), tolerance("db"),
             "dB"});
        add({prefix + "h (phase)", h, expected,
             phase_error_deg(phase_deg(h), phase_deg(expected)), tolerance("phase_deg"), "deg"});
    }
    level(prefix + "abs_db", level_db(h), "db");
    if (wants(prefix + "phase_deg"))
        phase(prefix + "phase_deg", phase_deg(h), tolerance("phase_deg"));
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
