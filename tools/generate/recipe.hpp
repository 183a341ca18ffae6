#pragma once

#include <optional>
#include <string>
#include <vector>

#include "firmware/fw_extract.h"
#include "scenes/catalogue.hpp"
#include "sim/session.hpp"

namespace specula {

/// Which tables of a frame are kept.
struct StoredForms {
    bool adc = true;
    bool profiles = false;
    bool features = false;

    bool operator==(const StoredForms&) const = default;
};

/// Reads `adc`, `profiles`, `features`. Throws InputError for other words, doubles and none.
StoredForms stored_forms(const std::vector<std::string>& names);

/// Everything that decides the frames of a generated dataset.
struct Recipe {
    std::string name;    ///< the file's stem
    std::string source;  ///< the file's whole text
    std::uint64_t seed = 0;
    int worlds = 1;
    Radar radar;
    double nominal_height_m = 0.45;
    Solver solver;
    Population population;
    Condition condition;
    StoredForms stored;
    fw_extract_config descriptor{};
    /// The same in words, `key = value` per line, comments and order of the files left out: what a
    /// run that is taken up again, or a shard of another machine, is compared by.
    std::string text;

    std::size_t n_sessions() const;
    std::size_t n_frames() const;
    std::size_t codes_per_frame() const;
};

/// What a user may say besides the file.
struct RecipeRequest {
    std::filesystem::path file{};
    std::string condition{};  ///< of a study; empty: its training recordings
    std::optional<std::uint64_t> seed{};
    std::optional<int> worlds{};
    std::vector<std::string> store{};  ///< empty: the file's
};

/// Reads a dataset (scenes/datasets) or a study (scenes/experiments).
Recipe read_recipe(const RecipeRequest& request, const Catalogue& catalogue);

/// The first line in which two recipe texts differ, in words: `seed = 7 there, 8 here`; empty where
/// they do not.
std::string recipe_difference(const std::string& there, const std::string& here);

/// What its sessions are simulated from. Borrows both.
Bench bench_of(const Recipe& recipe, const Library& materials);

}  // namespace specula
