#pragma once

#include <string>

#include "materials/dispersion.hpp"

namespace specula {

/// A medium, with where its numbers come from and where they hold.
struct Material {
    std::string name;    ///< as scenes call it
    std::string title;   ///< for people
    std::string source;  ///< paper, recommendation or datasheet of the numbers
    double valid_min_hz = 0.0;
    double valid_max_hz = 0.0;
    Dispersion dispersion;

    /// The medium at a frequency > 0; outside the valid band it extrapolates (ask `valid_at`).
    Electrics at(double frequency_hz) const {
        return std::visit([&](const auto& model) { return model.at(frequency_hz); }, dispersion);
    }
    bool valid_at(double frequency_hz) const {
        return frequency_hz >= valid_min_hz && frequency_hz <= valid_max_hz;
    }
    bool is_metal() const { return std::holds_alternative<Conductive>(dispersion); }
};

/// Reads one material file; its name is the file's stem.
/// Keys: title, source, valid_ghz = [min, max], model, and the model's own.
Material read_material(const std::filesystem::path& file);

}  // namespace specula
