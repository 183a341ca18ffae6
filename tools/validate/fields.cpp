#include "tools/validate/fields.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string shortened(const nlohmann::json& value) {
    constexpr std::size_t longest = 40;
    std::string text = value.dump(-1, ' ', true);  // one line of ASCII
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

std::string interval(const Range& range) {
    const std::string low =
        range.min_excluded ? format("above {}", range.min) : format("of {} or more", range.min);
    const std::string high =
        range.max_excluded ? format("below {}", range.max) : format("up to {}", range.max);
    if (std::isinf(range.max)) return low;
    return std::isinf(range.min) ? high : low + " and " + high;
}

}  // namespace

Fields::Fields(const nlohmann::json& object, std::string where) : where_(std::move(where)) {
    SPECULA_EXPECT(object.is_object());
    flatten(object, "");
}

void Fields::flatten(const nlohmann::json& object, const std::string& prefix) {
    for (const auto& [name, value] : object.items()) {
        if (value.is_null()) continue;
        if (value.is_object())
            flatten(value, prefix + name + ".");
        else
            values_[prefix + name] = &value;
    }
}

std::vector<std::string> Fields::names() const {
    std::vector<std::string> all;
    for (const auto& [name, value] : values_) all.push_back(name);
    return all;
}

void Fields::fail(const std::string& name, const std::string& problem,
                  const std::string& remedy) const {
    const auto found = values_.find(name);
    const std::string value = found == values_.end() ? "" : " = " + shortened(*found->second);
    throw InputError(format("{}.{}{}: {}; {}", where_, name, value, problem, remedy));
}

const nlohmann::json& Fields::at(const std::string& name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) fail(name, "missing", "this kind of case needs it");
    read_.insert(name);
    return *found->second;
}

double Fields::checked(const std::string& name, const nlohmann::json& value, Range range) const {
    if (!value.is_number()) fail(name, "not a number", "give a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) fail(name, "not a finite number", "give one");
    if (!range.holds(number)) fail(name, "out of range", "use a value " + interval(range));
    return number;
}

double Fields::number(const std::string& name, Range range) const {
    return checked(name, at(name), range);
}

double Fields::number_or(const std::string& name, double fallback, Range range) const {
    return has(name) ? number(name, range) : fallback;
}

double Fields::number_of(std::initializer_list<const char*> names, Range range) const {
    for (const char* name : names)
        if (has(name)) return number(name, range);
    return number(*names.begin(), range);  // says that it is missing
}

int Fields::count(const std::string& name, Range range) const {
    const double value = number(name, range);
    if (value != std::floor(value) || std::abs(value) > 1e9)
        fail(name, "not a whole number", "give one");
    return static_cast<int>(value);
}

int Fields::count_or(const std::string& name, int fallback, Range range) const {
    return has(name) ? count(name, range) : fallback;
}

std::string Fields::text(const std::string& name) const {
    const nlohmann::json& value = at(name);
    if (!value.is_string()) fail(name, "not a text", "give one in quotes");
    return value.get<std::string>();
}

bool Fields::flag(const std::string& name) const {
    const nlohmann::json& value = at(name);
    if (!value.is_boolean()) fail(name, "neither true nor false", "give one of them");
    return value.get<bool>();
}

Complex Fields::complex_of(const std::string& name, const nlohmann::json& value) const {
    if (value.is_number()) return checked(name, value, Range::any());
    const char* remedy = "give a number or [real, imaginary]";
    if (!value.is_array() || value.size() != 2) fail(name, "not a complex number", remedy);
    for (const nlohmann::json& part : value)
        if (!part.is_number()) fail(name, "not a complex number", remedy);
    return {checked(name, value[0], Range::any()), checked(name, value[1], Range::any())};
}

Complex Fields::complex(const std::string& name) const {
    return complex_of(name, at(name));
}

Complex Fields::permittivity(const std::string& name) const {
    const Complex value = complex(name);
    if (value.imag() > 0.0)
        fail(name, "a medium with gain", "losses are eps' - j eps'': give an imaginary part <= 0");
    if (value == 0.0) fail(name, "no medium", "give a value other than 0");
    return value;
}

const nlohmann::json& Fields::list_at(const std::string& name) const {
    const nlohmann::json& value = at(name);
    if (!value.is_array()) fail(name, "not a list", "give one in brackets");
    return value;
}

std::vector<double> Fields::numbers(const std::string& name, Range range) const {
    std::vector<double> all;
    for (const nlohmann::json& value : list_at(name)) all.push_back(checked(name, value, range));
    return all;
}

std::vector<Complex> Fields::complexes(const std::string& name) const {
    std::vector<Complex> all;
    for (const nlohmann::json& value : list_at(name)) all.push_back(complex_of(name, value));
    return all;
}

std::vector<std::vector<double>> Fields::rows(const std::string& name) const {
    std::vector<std::vector<double>> all;
    for (const nlohmann::json& row : list_at(name)) {
        if (!row.is_array()) fail(name, "not a list of lists", "give a list of lists of numbers");
        std::vector<double> values;
        for (const nlohmann::json& value : row)
            values.push_back(checked(name, value, Range::any()));
        all.push_back(std::move(values));
    }
    return all;
}

std::vector<std::string> Fields::texts() const {
    std::vector<std::string> all;
    for (const auto& [name, value] : values_)
        if (value->is_string()) all.push_back(value->get<std::string>());
    return all;
}

bool Fields::is_text(const std::string& name) const {
    return has(name) && values_.at(name)->is_string();
}

bool Fields::is_number(const std::string& name) const {
    return has(name) && values_.at(name)->is_number();
}

bool Fields::is_list(const std::string& name) const {
    return has(name) && values_.at(name)->is_array();
}

void Fields::describe(std::initializer_list<const char*> names) const {
    for (const char* name : names) read_.insert(name);
}

std::vector<std::string> Fields::unread() const {
    std::vector<std::string> left;
    for (const auto& [name, value] : values_)
        if (read_.count(name) == 0) left.push_back(name);
    return left;
}

}  // namespace specula
