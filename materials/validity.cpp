#include "materials/validity.hpp"

#include <algorithm>

#include "sim/core/format.hpp"

namespace specula {

namespace {

void add_once(std::vector<BandWarning>& warnings, const BandWarning& warning) {
    const bool known = std::any_of(warnings.begin(), warnings.end(), [&](const auto& other) {
        return other.material == warning.material && other.number == warning.number;
    });
    if (!known) warnings.push_back(warning);
}

void collect(const Material& material, const FrequencyBand& used,
             std::vector<BandWarning>& warnings) {
    const bool holds = material.valid().holds(used);
    if (!holds) add_once(warnings, {material.name, "", material.valid(), used});
    for (const NumberOrigin& number : material.numbers)
        if (holds && !number.valid.holds(used))
            add_once(warnings, {material.name, number.key, number.valid, used});
    for (const Ingredient& part : material.ingredients()) collect(*part.material, used, warnings);
}

}  // namespace

std::string BandWarning::text() const {
    const std::string what = number.empty() ? material : material + ", " + number;
    return format("{}: valid from {}, used from {}", what, valid.text(), used.text());
}

std::vector<BandWarning> band_warnings(const Material& material, const FrequencyBand& used) {
    std::vector<BandWarning> warnings;
    collect(material, used, warnings);
    return warnings;
}

std::vector<BandWarning> band_warnings(const Library& library,
                                       const std::vector<std::string>& names,
                                       const FrequencyBand& used) {
    std::vector<BandWarning> warnings;
    for (const std::string& name : names)
        if (const Material* material = library.find(name)) collect(*material, used, warnings);
    return warnings;
}

}  // namespace specula
