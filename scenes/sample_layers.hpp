#pragma once

#include "scenes/catalogue.hpp"
#include "scenes/sample.hpp"

namespace specula {

/// Reads what a sample is made of: `material`, `thickness`, `roughness` and `correlation_length`,
/// or one [[layer]] for each layer, the one facing the radar first; and `grain`, `piece`, `backing`
/// and `opaque`. Its shape must be in it already: a mesh without thickness and layers is solid.
void read_matter(Section& section, const Catalogue& catalogue, Sample& sample);

}  // namespace specula
