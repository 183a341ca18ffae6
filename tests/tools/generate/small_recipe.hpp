#pragma once

#include <fstream>
#include <string>

#include "tests/classifier/temporary_folder.hpp"
#include "tools/generate/generate.hpp"
#include "tools/generate/recipe.hpp"

namespace specula {

/// A dataset of small plates: two classes, so many sessions of two frames that there are some
/// shards.
inline const char* const small_recipe_text =
    "title = \"small\"\nseed = 5\nworlds = 5\nradar = \"iwrl6432boost\"\nnominal_height_mm = 450\n"
    "store = [\"adc\", \"features\"]\n"
    "[recordings]\nsamples = 2\nsessions = 8\nframes = 2\n"
    "[geometry]\nheight_mm = { uniform = [400, 500], sampling = \"quasi\" }\n"
    "[sample]\nsize_mm = [40, 40]\n"
    "[[class]]\nname = \"iron\"\nmaterial = \"iron\"\nthickness_mm = 3\n"
    "[[class]]\nname = \"wood\"\nmaterial = \"wood\"\nthickness_mm = { normal = [18, 1] }\n"
    "[session]\ngain_db = { normal = [0, 0.3] }\n"
    "[frame]\ndisplacement_um = { normal = [0, 35] }\n";

inline const Catalogue& own_catalogue() {
    static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    return catalogue;
}

/// A recipe from a text, in a folder of its own.
class SmallRecipe {
  public:
    explicit SmallRecipe(const std::string& text = small_recipe_text) {
        std::ofstream(folder / "small.toml") << text;
    }
    Recipe read(RecipeRequest request = {}) const {
        request.file = folder / "small.toml";
        return read_recipe(request, own_catalogue());
    }
    const TemporaryFolder folder;
};

}  // namespace specula
