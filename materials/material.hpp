#pragma once

#include <string>
#include <vector>

#include "materials/dispersion.hpp"
#include "materials/grain.hpp"
#include "materials/provenance.hpp"

namespace specula {

/// The kinds of matter that lists are grouped by, in their order.
const std::vector<std::string>& material_groups();

/// A medium, with where its numbers come from and where they hold.
struct Material {
    std::string name;    ///< as scenes call it
    std::string title;   ///< for people
    std::string group;   ///< one of `material_groups`
    std::string source;  ///< paper, recommendation or datasheet of the numbers
    Evidence evidence = Evidence::estimate;
    double valid_min_hz = 0.0;
    double valid_max_hz = FrequencyBand{}.max_hz;
    std::vector<NumberOrigin> numbers;  ///< those of another origin or band
    Dispersion dispersion;

    /// The medium at a frequency > 0; outside the valid band it extrapolates (ask `valid_at`).
    Electrics at(double frequency_hz) const {
        return std::visit([&](const auto& model) { return model.at(frequency_hz); }, dispersion);
    }
    /// The same for fields along and across the grain.
    Grained grained(double frequency_hz) const;
    bool has_grain() const { return std::holds_alternative<Wood>(dispersion); }

    FrequencyBand valid() const { return {valid_min_hz, valid_max_hz}; }
    /// Whether all its numbers, and those of the materials in it, hold there.
    bool valid_at(double frequency_hz) const;
    bool is_metal() const { return std::holds_alternative<Conductive>(dispersion); }
    /// The materials it is made of; empty for most.
    std::vector<Ingredient> ingredients() const;
};

/// Reads one material file; its name is the file's stem, `lookup` knows the materials it may name.
/// Keys: title, group (default "other"), source, evidence, valid_ghz = [min, max], [[number]],
/// model, and the model's own.
Material read_material(const std::filesystem::path& file, const MaterialLookup& lookup);

/// The same for a file that names no other material.
Material read_material(const std::filesystem::path& file);

}  // namespace specula
