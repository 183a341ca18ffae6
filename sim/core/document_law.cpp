#include <array>
#include <cmath>

#include "sim/core/document_table.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

using Named = Section::Table::Named;

constexpr const char* laws_there_are =
    "write a number, { uniform = [low, high] }, { normal = [mean, sd] }, "
    "{ factor = [median, ratio] }, { log_normal = [median, sd of the logarithm] } or "
    "{ choice = [values] }";

/// The key of the law in its table, and its numbers.
struct LawEntry {
    std::string name;
    Named numbers;
};

LawEntry entry_of(const Named& named, const toml::table& law, const std::string& name) {
    return {name, {named.key + "." + name, law.get(name), named.to_si, named.unit}};
}

}  // namespace

Distribution Section::Table::checked_law(const Named& named, const Range& range) const {
    const toml::table* law = named.node->as_table();
    if (!law) return checked_number(named, *named.node, range);
    if (law->size() != 1) fail(named.key, named.node, "is not a value or a law", laws_there_are);
    return checked_entry(named, std::string(law->begin()->first.str()), range);
}

Distribution Section::Table::checked_entry(const Named& named, const std::string& name,
                                           const Range& range) const {
    const LawEntry entry = entry_of(named, *named.node->as_table(), name);
    const Named& inner = entry.numbers;
    if (entry.name == "uniform") {
        const auto v = checked_numbers(inner, 2, range);
        if (!(v[0] <= v[1]))
            fail(inner.key, inner.node, "runs backwards", "put the smaller value first");
        return Distribution(Distribution::Uniform{v[0], v[1]});
    }
    if (entry.name == "normal") {
        const auto v = checked_numbers(inner, 2, Range::any());
        if (!range.holds(v[0]) || !(v[1] >= 0.0))
            fail(inner.key, inner.node, "is out of range",
                 "give [mean, standard deviation]: a mean " +
                     described(range, named.to_si, named.unit) +
                     ", a standard deviation at least 0");
        return Distribution(Distribution::Normal{v[0], v[1]});
    }
    if (entry.name == "factor" || entry.name == "log_normal") {
        const bool factor = entry.name == "factor";
        const Named plain{inner.key, inner.node, 1.0, ""};
        const auto v = checked_numbers(plain, 2, factor ? Range::above(0.0) : Range::at_least(0.0));
        if (!(v[0] > 0.0) || !range.holds(v[0] * named.to_si) || (factor && !(v[1] >= 1.0)))
            fail(inner.key, inner.node, "is out of range",
                 format("give [median, {}]: a median {}, {}",
                        factor ? "ratio" : "standard deviation of the logarithm",
                        described(range, named.to_si, named.unit),
                        factor ? "a ratio at least 1" : "a deviation at least 0"));
        return Distribution(
            Distribution::Factor{v[0] * named.to_si, factor ? v[1] : std::exp(v[1])});
    }
    if (entry.name == "choice")
        return Distribution(Distribution::Choice{checked_numbers(inner, 0, range)});
    const std::string near =
        nearest_word(name, {"uniform", "normal", "factor", "log_normal", "choice"});
    fail(inner.key, inner.node, "is not a value or a law",
         (near.empty() ? "" : "did you mean " + near + "? ") + laws_there_are);
}

SampledLaw Section::Table::checked_sampled_law(const Named& named, const Range& range) const {
    const toml::table* law = named.node->as_table();
    if (!law) return {checked_number(named, *named.node, range)};
    if (law->contains("grid")) {
        if (law->size() != 1)
            fail(named.key, named.node, "is a grid and something else", "keep the grid alone");
        const auto values = checked_numbers(entry_of(named, *law, "grid").numbers, 0, range);
        return {Distribution(Distribution::Choice{values}), Sampling::grid};
    }
    const toml::node* sampling = law->get("sampling");
    if (!sampling) return {checked_law(named, range)};
    std::vector<std::string> names;
    for (const auto& [key, node] : *law)
        if (key.str() != "sampling") names.emplace_back(key.str());
    if (names.size() != 1) fail(named.key, named.node, "is not a value or a law", laws_there_are);
    static const std::array<std::pair<const char*, Sampling>, 3> samplings{
        {{"random", Sampling::random},
         {"stratified", Sampling::stratified},
         {"quasi", Sampling::quasi}}};
    for (const auto& [name, kind] : samplings)
        if (sampling->value_or(std::string()) == name)
            return {checked_entry(named, names.front(), range), kind};
    fail(named.key + ".sampling", sampling, "is not known",
         "use \"random\", \"stratified\" or \"quasi\"");
}

SampledLaw Section::sampled_law(const std::string& name, Unit unit, Range range,
                                const Distribution& fallback) {
    const auto named = table_->find_quantity(name, unit);
    return named ? table_->checked_sampled_law(*named, range) : SampledLaw{fallback};
}

}  // namespace specula
