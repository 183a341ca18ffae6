#include "tools/sweep/axis.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr const char* axis_forms = "write one value, first:last:step, or several with commas";

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; begin <= text.size(); begin = end + 1) {
        end = std::min(text.find(separator, begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        const auto first = part.find_first_not_of(" \t");
        const auto last = part.find_last_not_of(" \t");
        parts.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
    }
    return parts;
}

double number_of(const std::string& text, const Refusal& refuse) {
    const std::string digits = text.size() > 1 && text[0] == '+' ? text.substr(1) : text;
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() ||
        !std::isfinite(value))
        refuse(format("\"{}\" is not a number", text), axis_forms);
    return value;
}

double rounded(double value) {
    return std::abs(value) < 1e6 ? std::round(value * 1e9) / 1e9 : value;
}

void add_range(const std::vector<double>& limits, const Refusal& refuse,
               std::vector<double>& values) {
    const double first = limits[0], last = limits[1], step = limits[2];
    if (step == 0.0) refuse("a step of 0 leads nowhere", "use a step above 0");
    if (step < 0.0)
        refuse(format("the step {:g} is negative", step), "ranges go upwards: use a step above 0");
    if (first > last)
        refuse(format("runs backwards from {:g} to {:g}", first, last),
               "put the lower value first");
    const double steps = std::floor((last - first) / step + 1e-9);
    if (!(steps + static_cast<double>(values.size()) < most_values_per_axis))
        refuse(format("makes {:.3g} values", steps + 1.0),
               format("use a larger step; an axis has at most {}", most_values_per_axis));
    for (double i = 0.0; i <= steps; i += 1.0) values.push_back(rounded(first + i * step));
}

void check_range(const std::vector<double>& values, const AxisRules& rules, const Refusal& refuse) {
    for (const double value : values) {
        const bool low = rules.min_excluded ? value <= rules.min : value < rules.min;
        if (!low && value <= rules.max) continue;
        refuse(format("{:g} {} is out of range", value, rules.unit),
               format("use values {} {:g} up to {:g} {}", rules.min_excluded ? "above" : "from",
                      rules.min, rules.max, rules.unit));
    }
}

}  // namespace

std::vector<double> read_axis(const std::string& text, const AxisRules& rules,
                              const Refusal& refuse) {
    std::vector<double> values;
    for (const std::string& part : parts_of(text, ',')) {
        std::vector<double> limits;
        for (const std::string& number : parts_of(part, ':'))
            limits.push_back(number_of(number, refuse));
        if (limits.size() == 1)
            values.push_back(limits[0]);
        else if (limits.size() == 3)
            add_range(limits, refuse, values);
        else
            refuse(format("\"{}\" has {} numbers", part, limits.size()), axis_forms);
    }
    check_range(values, rules, refuse);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    SPECULA_EXPECT(!values.empty());
    return values;
}

std::vector<std::string> read_words(const std::string& text, const Refusal& refuse) {
    const std::vector<std::string> words = parts_of(text, ',');
    for (const std::string& word : words)
        if (word.empty()) refuse("holds an empty name", "write names with one comma between them");
    return words;
}

}  // namespace specula
