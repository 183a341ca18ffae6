#include "sim/core/document_table.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::string shown_value(const toml::node& node) {
    if (const auto* text = node.as_string()) return format("\"{}\"", text->get());
    if (const auto* whole = node.as_integer()) return format("{}", whole->get());
    if (const auto* real = node.as_floating_point()) return format("{}", real->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (node.is_table()) return "{...}";
    if (const auto* array = node.as_array()) {
        std::string list = "[";
        for (const toml::node& item : *array)
            list += (list.size() > 1 ? ", " : "") + shown_value(item);
        return list + "]";
    }
    return "(a date or time)";
}

std::string described(const Range& range, double to_si, std::string_view unit) {
    const auto in_unit = [&](double si) {
        return format("{:.6g}{}{}", si / to_si, unit.empty() ? "" : " ", unit);
    };
    const bool has_min = std::isfinite(range.min), has_max = std::isfinite(range.max);
    const char* low = range.min_excluded ? "above " : "at least ";
    const char* high = range.max_excluded ? "below " : "at most ";
    if (has_min && has_max) return low + in_unit(range.min) + " and " + high + in_unit(range.max);
    if (has_min) return low + in_unit(range.min);
    if (has_max) return high + in_unit(range.max);
    return "a finite number";
}

void Section::Table::fail(const std::string& key, const toml::node* node,
                          const std::string& problem, const std::string& remedy) const {
    const toml::node* place = node ? node : table;
    const auto line = std::max<std::uint32_t>(1, place->source().begin.line);
    const std::string value = node ? " = " + shown_value(*node) : "";
    throw InputError(
        format("{}:{}: {}{}{}: {}; {}", source->name, line, path, key, value, problem, remedy));
}

const toml::node* Section::Table::find(const std::string& key) {
    known.insert(key);
    return table->get(key);
}

const toml::node& Section::Table::need(const std::string& key) {
    if (const toml::node* node = find(key)) return *node;
    fail(key, nullptr, "is missing", "add it");
}

std::optional<Section::Table::Named> Section::Table::find_quantity(const std::string& name,
                                                                   Unit unit) {
    std::optional<Named> found;
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
    const std::string first = name + "_" + std::string(suffixes_of(unit)[0].suffix);
    fail(first, nullptr, "is missing", "add it");
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
             "give a number that is " + described(range, named.to_si, named.unit));
    const double si = value * named.to_si;
    if (!range.holds(si))
        fail(named.key, named.node, "is out of range",
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

Distribution Section::Table::checked_law(const Named& named, const Range& range) const {
    const toml::table* law = named.node->as_table();
    if (!law) return checked_number(named, *named.node, range);
    if (law->size() == 1) {
        const std::string name(law->begin()->first.str());
        const toml::node& node = law->begin()->second;
        const Named inner{named.key + "." + name, &node, named.to_si, named.unit};
        if (name == "uniform") {
            const auto v = checked_numbers(inner, 2, range);
            if (!(v[0] <= v[1]))
                fail(inner.key, &node, "runs backwards", "put the smaller value first");
            return Distribution(Distribution::Uniform{v[0], v[1]});
        }
        if (name == "normal") {
            const auto v = checked_numbers(inner, 2, Range::any());
            if (!range.holds(v[0]) || !(v[1] >= 0.0))
                fail(inner.key, &node, "is out of range",
                     "give [mean, standard deviation], the mean " +
                         described(range, named.to_si, named.unit) +
                         ", the standard deviation at least 0");
            return Distribution(Distribution::Normal{v[0], v[1]});
        }
        if (name == "factor") {
            const Named plain{inner.key, &node, 1.0, ""};
            const auto v = checked_numbers(plain, 2, Range::above(0.0));
            if (!range.holds(v[0] * named.to_si) || !(v[1] >= 1.0))
                fail(inner.key, &node, "is out of range",
                     "give [median, ratio], the median " +
                         described(range, named.to_si, named.unit) + ", the ratio at least 1");
            return Distribution(Distribution::Factor{v[0] * named.to_si, v[1]});
        }
    }
    fail(named.key, named.node, "is not a value or a law",
         "write a number, { uniform = [low, high] }, { normal = [mean, sd] } or "
         "{ factor = [median, ratio] }");
}
}  // namespace specula
