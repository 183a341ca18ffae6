#include "tools/report/number_text.hpp"

#include <cmath>

#include "sim/core/format.hpp"

namespace specula {
namespace {

constexpr const char* no_break_space = "\u00a0";
constexpr const char* minus = "\u2212";

}  // namespace

std::string fixed_text(double value, int n_decimals) {
    if (!std::isfinite(value)) return "\u2013";
    const std::string digits = format("{:.{}f}", std::abs(value), n_decimals);
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    return value < 0.0 && !is_zero ? minus + digits : digits;
}

std::string signed_text(double value, int n_decimals) {
    const std::string text = fixed_text(value, n_decimals);
    const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
    return value > 0.0 && !is_zero ? "+" + text : text;
}

std::string percent_number(double share) {
    return fixed_text(100.0 * share, 1);
}

std::string percent_text(double share) {
    return percent_number(share) + no_break_space + "%";
}

std::string points_text(double share) {
    const std::string number = percent_number(share);
    return number + no_break_space + (number == "1.0" ? "point" : "points");
}

std::string range_number(const Interval& interval) {
    return percent_number(interval.low) + " to " + percent_number(interval.high);
}

std::string range_text(const Interval& interval) {
    return range_number(interval) + no_break_space + "%";
}

std::string count_text(std::int64_t count) {
    std::string digits = std::to_string(std::llabs(count));
    if (digits.size() > 4)
        for (std::size_t i = digits.size() - 3; i > 0 && i<digits.size(); i -= i> 3 ? 3 : i)
            digits.insert(i, no_break_space);
    return count < 0 ? minus + digits : digits;
}

}  // namespace specula
