#include "materials/material.hpp"

#include "sim/core/kind.hpp"

namespace specula {

Material read_material(const std::filesystem::path& file) {
    Section section = Section::read(file);
    Material material;
    material.name = file.stem().string();
    material.title = section.text("title");
    material.source = section.text("source");
    const auto band_hz = section.quantities("valid", Unit::frequency, 2, Range::above(0.0));
    if (!(band_hz[0] < band_hz[1]))
        section.fail("valid_ghz", "runs backwards", "put the lower frequency first");
    material.valid_min_hz = band_hz[0];
    material.valid_max_hz = band_hz[1];
    material.dispersion = read_kind<Dispersion>(section, "model");
    section.finish();
    return material;
}

}  // namespace specula
