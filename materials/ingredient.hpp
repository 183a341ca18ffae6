#pragma once

#include <functional>
#include <memory>
#include <string>

#include "materials/electrics.hpp"
#include "sim/core/document.hpp"

namespace specula {

struct Material;

/// The material that `section.<key>` names. Throws InputError at that place when there is none, or
/// when it would have to contain itself.
using MaterialLookup =
    std::function<std::shared_ptr<const Material>(Section& section, const std::string& key)>;

/// A material that is part of another one.
struct Ingredient {
    std::shared_ptr<const Material> material;  ///< never null once read

    Electrics at(double frequency_hz) const;

    /// `key = "name"`, or a table `[key]` that has `model` and the model's own keys. Refuses
    /// metals: the mixing laws hold for grains that the field fills.
    static Ingredient read(Section& section, const std::string& key, const MaterialLookup& lookup);
};

}  // namespace specula
