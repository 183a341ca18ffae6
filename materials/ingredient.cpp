#include "materials/ingredient.hpp"

#include "materials/material.hpp"
#include "sim/core/kind.hpp"

namespace specula {

Electrics Ingredient::at(double frequency_hz) const {
    return material->at(frequency_hz);
}

Ingredient Ingredient::read(Section& section, const std::string& key,
                            const MaterialLookup& lookup) {
    Ingredient ingredient;
    if (section.has_section(key)) {
        Section described = section.section(key);
        auto material = std::make_shared<Material>();
        material->dispersion = read_kind<Dispersion>(described, "model", lookup);
        described.finish();
        ingredient.material = std::move(material);
    } else {
        ingredient.material = lookup(section, key);
    }
    if (ingredient.material->is_metal())
        section.fail(key, "is a metal, which no mixing law here describes",
                     "use a dielectric, or a layer of metal in the scene");
    return ingredient;
}

}  // namespace specula
