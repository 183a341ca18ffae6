#include "materials/material.hpp"

#include "materials/validity.hpp"
#include "sim/core/kind.hpp"

namespace specula {

const std::vector<std::string>& material_groups() {
    static const std::vector<std::string> groups{"metal",    "plastic", "wood",  "stone",
                                                 "building", "glass",   "water", "tissue",
                                                 "soil",     "film",    "other"};
    return groups;
}

Grained Material::grained(double frequency_hz) const {
    return std::visit(
        [&](const auto& model) -> Grained {
            if constexpr (requires { model.grained(frequency_hz); })
                return model.grained(frequency_hz);
            else
                return {model.at(frequency_hz), model.at(frequency_hz)};
        },
        dispersion);
}

std::vector<Ingredient> Material::ingredients() const {
    return std::visit(
        [](const auto& model) -> std::vector<Ingredient> {
            if constexpr (requires { model.ingredients(); })
                return model.ingredients();
            else
                return {};
        },
        dispersion);
}

bool Material::valid_at(double frequency_hz) const {
    return band_warnings(*this, {frequency_hz, frequency_hz}).empty();
}

Material read_material(const std::filesystem::path& file, const MaterialLookup& lookup) {
    Section section = Section::read(file);
    Material material;
    material.name = file.stem().string();
    material.title = section.text("title");
    material.group = section.choice("group", material_groups(), "other");
    material.source = section.text("source");
    material.evidence = read_evidence(section);
    const FrequencyBand valid = FrequencyBand::read(section);
    material.valid_min_hz = valid.min_hz;
    material.valid_max_hz = valid.max_hz;
    material.dispersion = read_kind<Dispersion>(section, "model", lookup);
    material.numbers = read_number_origins(section, valid);
    section.finish();
    return material;
}

Material read_material(const std::filesystem::path& file) {
    return read_material(file, [](Section& section, const std::string& key) {
        section.fail(key, "names another material, and there is no library at hand",
                     "describe it in place, as a table with a model");
        return std::shared_ptr<const Material>();
    });
}

}  // namespace specula
