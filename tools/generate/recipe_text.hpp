#pragma once

#include "tools/generate/recipe.hpp"

namespace specula {

/// Recipe::text: version of the program, settings, and every value of the experiment, of the radar
/// and of the materials that occur in it.
std::string recipe_text(const Recipe& recipe, const Section& experiment,
                        const Catalogue& catalogue);

}  // namespace specula
