#include "sim/core/document_table.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Control characters would break the line, or do worse to a terminal.
std::string printable(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        line += c == '\n'                    ? "\\n"
                : byte < ' ' || byte == 0x7f ? format("\\x{:02x}", byte)
                                             : std::string(1, c);
    }
    return line;
}

/// At most 80 bytes, whole UTF-8 characters.
std::string shortened(std::string line) {
    if (line.size() <= 80) return line;
    std::size_t end = 77;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80) --end;
    return line.substr(0, end) + "...";
}

std::string whole_value(const toml::node& node) {
    if (const auto* text = node.as_string()) return format("\"{}\"", text->get());
    if (const auto* whole = node.as_integer()) return format("{}", whole->get());
    if (const auto* real = node.as_floating_point()) return format("{}", real->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (node.is_table()) return "{...}";
    if (const auto* array = node.as_array()) {
        std::string list = "[";
        for (const toml::node& item : *array)
            list += (list.size() > 1 ? ", " : "") + whole_value(item);
        return list + "]";
    }
    return "(a date or time)";
}

/// `a, b or c`: the keys under which a quantity may be written.
std::string spelled_keys(const std::string& name, Unit unit) {
    const auto suffixes = suffixes_of(unit);
    std::string list;
    for (std::size_t i = 0; i < suffixes.size(); ++i) {
        if (i > 0) list += i + 1 == suffixes.size() ? " or " : ", ";
        list += name + "_" + std::string(suffixes[i].suffix);
    }
    return list;
}

}  // namespace

std::string shown_value(const toml::node& node) {
    return shortened(printable(whole_value(node)));
}

std::string described(const Range& range, double to_si, std::string_view unit) {
    const auto in_unit = [&](double si) {
        int digits = 10;  // more where fewer would state a value outside
        std::string text = format("{:.{}g}", si / to_si, digits);
        while (digits < 17 && range.holds(si) && !range.holds(std::stod(text) * to_si))
            text = format("{:.{}g}", si / to_si, ++digits);
        return text + (unit.empty() ? "" : " ") + (unit == "db" ? "dB" : std::string(unit));
    };
    const bool has_min = std::isfinite(range.min), has_max = std::isfinite(range.max);
    const char* low = range.min_excluded ? "above " : "at least ";
    const char* high = range.max_excluded ? "below " : "at most ";
    if (has_min && has_max) return low + in_unit(range.min) + " and " + high + in_unit(range.max);
    if (has_min) return low + in_unit(range.min);
    if (has_max) return high + in_unit(range.max);
    return "that is finite";
}

void Section::Table::fail(const std::string& key, const toml::node* node,
                          const std::string& problem, const std::string& remedy) const {
    const toml::node* place = node ? node : table;
    const auto line = std::max<std::uint32_t>(1, place->source().begin.line);
    const std::string value = node ? " = " + shown_value(*node) : "";
    throw InputError(format("{}:{}: {}{}: {}; {}", source->name, line,
                            shortened(printable(path + key)), value, problem, remedy));
}

void Section::Table::fail_missing(const std::string& key,
                                  const std::vector<std::string>& spellings) const {
    std::vector<std::string> unread;
    for (const auto& [name, node] : *table)
        if (!known.count(std::string(name.str()))) unread.emplace_back(name.str());
    for (const std::string& spelling : spellings) {
        const std::string near = nearest_word(spelling, unread);
        if (near.empty()) continue;
        const auto line = table->get(near)->source().begin.line;
        const std::string meant = nearest_word(near, spellings);  // with the suffix it has there
        fail(meant.empty() ? key : meant, nullptr, "is missing",
             format("add it, or is it meant by {} in line {}?", printable(near), line));
    }
    fail(key, nullptr, "is missing", "add it");
}

void Section::Table::fail_unknown(const std::string& key) const {
    const toml::node* node = table->get(key);
    const auto bare = quantities.find(key);
    if (bare != quantities.end())
        fail(key, node, "has no unit", "write " + spelled_keys(key, bare->second));
    const std::string where = path.empty() ? "this file" : "this table";
    const std::string near = nearest_word(key, {known.begin(), known.end()});
    if (!near.empty()) fail(key, node, "is not a key of " + where, "did you mean " + near + "?");
    for (const auto& [name, unit] : quantities)
        if (key.rfind(name + "_", 0) == 0)
            fail(key, node, "is not a key of " + where,
                 "if it is a unit, write " + spelled_keys(name, unit));
    fail(key, node, "is not a key of " + where, "remove it");
}

const toml::node* Section::Table::find(const std::string& key) {
    known.insert(key);
    return table->get(key);
}

const toml::node& Section::Table::need(const std::string& key) {
    if (const toml::node* node = find(key)) return *node;
    fail_missing(key, {key});
}

std::optional<Section::Table::Named> Section::Table::find_quantity(const std::string& name,
                                                                   Unit unit) {
    std::optional<Named> found;
    quantities.emplace(name, unit);
    for (const UnitSuffix& suffix : suffixes_of(unit)) {
        const std::string key = name + "_" + std::string(suffix.suffix);
        const toml::node* node = find(key);
        if (!node) continue;
        if (found)
            fail(key, node, "is given twice, as " + path + found->key + " too", "keep one of them");
        found = Named{key, node, suffix.to_si, std::string(suffix.suffix)};
    }
    return found;
}

Section::Table::Named Section::Table::need_quantity(const std::string& name, Unit unit) {
    if (auto found = find_quantity(name, unit)) return *found;
    if (table->get(name)) fail_unknown(name);
    std::vector<std::string> spellings;
    for (const UnitSuffix& suffix : suffixes_of(unit))
        spellings.push_back(name + "_" + std::string(suffix.suffix));
    fail_missing(spellings.front(), spellings);
}

double Section::Table::checked_number(const Named& named, const toml::node& node,
                                      const Range& range) const {
    double value = 0.0;
    if (const auto* whole = node.as_integer())
        value = static_cast<double>(whole->get());
    else if (const auto* real = node.as_floating_point())
        value = real->get();
    else
        fail(named.key, named.node, "is not a number",
             "give a number " + described(range, named.to_si, named.unit));
    const double si = value * named.to_si;
    if (!range.holds(si))
        fail(named.key, named.node,
             std::isfinite(value) ? "is out of range" : "is not a finite number",
             "give a value " + described(range, named.to_si, named.unit));
    return si;
}

std::vector<double> Section::Table::checked_numbers(const Named& named, std::size_t size,
                                                    const Range& range) const {
    const toml::array* array = named.node->as_array();
    if (!array || array->empty() || (size > 0 && array->size() != size))
        fail(named.key, named.node, "is not a list of the right length",
             size > 0 ? format("give {} numbers: [...]", size) : "give a list: [...]");
    std::vector<double> values;
    for (const toml::node& item : *array) values.push_back(checked_number(named, item, range));
    return values;
}

}  // namespace specula
