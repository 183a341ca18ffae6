#include "tools/generate/recipe.hpp"

#include <algorithm>

#include "sim/core/document_seed.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/generate.hpp"
#include "tools/generate/recipe_text.hpp"
#include "tools/study/experiment.hpp"

namespace specula {

namespace {

constexpr int most_worlds = 1000;

std::vector<std::string> conditions_of(const Experiment& experiment) {
    std::vector<std::string> names{experiment.training.name};
    for (const Condition& condition : experiment.conditions) names.push_back(condition.name);
    return names;
}

Condition chosen_condition(const Experiment& experiment, const std::string& wanted) {
    if (wanted.empty() || wanted == experiment.training.name) return experiment.training;
    for (const Condition& condition : experiment.conditions)
        if (condition.name == wanted) return condition;
    throw InputError(format("--condition {}: is none of {}; use {}", wanted, experiment.file,
                            quoted_list(conditions_of(experiment))));
}

/// One condition of a study, as the study itself records it.
void take_study(Recipe& recipe, const RecipeRequest& request, const Catalogue& catalogue) {
    Experiment experiment = read_experiment(request.file, catalogue);
    recipe.seed = experiment.seed;
    recipe.worlds = experiment.full.worlds;
    recipe.condition = chosen_condition(experiment, request.condition);
    recipe.radar = std::move(experiment.radar);
    recipe.nominal_height_m = experiment.nominal_height_m;
    recipe.solver = experiment.solver;
    recipe.population = std::move(experiment.population);
    recipe.descriptor = experiment.descriptor;
}

/// [recordings]: how many pieces of each class, sessions of each piece, frames of each session.
Condition read_recordings(Section section, const std::string& name) {
    Condition condition;
    condition.name = name;
    condition.new_samples = true;
    const int pieces = section.count("samples", Range::between(1, Condition::most_sessions));
    condition.sessions_per_piece =
        section.count("sessions", Range::between(1, Condition::most_sessions));
    condition.frames = section.count("frames", Range::between(1, Condition::most_frames));
    condition.sessions = pieces * condition.sessions_per_piece;
    if (condition.sessions > Condition::most_sessions)
        section.fail(
            "sessions",
            format("times the samples makes {} sessions of a class in a world", condition.sessions),
            format("keep them to {}, and take more worlds", Condition::most_sessions));
    section.finish();
    return condition;
}

fw_extract_config usual_descriptor() {
    return {.first_bin = FW_DEFAULT_FIRST_BIN,
            .n_bins = FW_DEFAULT_N_BINS,
            .window = FW_WINDOW_BLACKMAN,
            .integration = FW_INTEGRATE_MEAN,
            .path = FW_RANGE_FLOAT};
}

void take_dataset(Recipe& recipe, Section& root, const Catalogue& catalogue) {
    root.text("title");
    recipe.seed = read_seed(root);
    recipe.worlds = root.count("worlds", Range::between(1, most_worlds));
    recipe.radar = catalogue.radar(root, "radar");
    recipe.nominal_height_m =
        root.quantity("nominal_height", Unit::length, Range::inside(0.0, 100.0));
    recipe.solver = read_solver(root);
    if (root.has("store")) {
        const std::vector<std::string> names = root.texts("store");
        try {
            recipe.stored = stored_forms(names);
        } catch (const InputError& error) {
            root.fail("store", error.what(), "use some of \"adc\", \"profiles\" and \"features\"");
        }
    }
    recipe.population = read_population(root, catalogue);
    recipe.condition = read_recordings(root.section("recordings"), recipe.name);
    recipe.condition.heights_m = {recipe.nominal_height_m};
    if (auto geometry = root.find_section("geometry"))
        recipe.condition.geometry_law =
            read_geometry(*geometry, recipe.radar, recipe.nominal_height_m);
    recipe.descriptor = usual_descriptor();
    if (auto descriptor = root.find_section("descriptor"))
        recipe.descriptor = read_descriptor(*descriptor, recipe.radar);
    root.finish();
}

/// The firmware's transforms, of which profiles and features are made, take no complex samples.
void check_forms(const Recipe& recipe) {
    if ((recipe.stored.profiles || recipe.stored.features) && recipe.radar.receiver.complex_samples)
        throw InputError(
            format("store: range profiles and features are made of real samples, and "
                   "the receiver of {} is complex; store \"adc\" alone",
                   recipe.radar.name));
}

}  // namespace

StoredForms stored_forms(const std::vector<std::string>& names) {
    StoredForms forms{.adc = false};
    for (const std::string& name : names) {
        bool* form = name == "adc"        ? &forms.adc
                     : name == "profiles" ? &forms.profiles
                     : name == "features" ? &forms.features
                                          : nullptr;
        if (!form) throw InputError(format("holds \"{}\"", name));
        if (*form) throw InputError(format("holds \"{}\" twice", name));
        *form = true;
    }
    return forms;
}

std::size_t Recipe::n_sessions() const {
    return session_count(condition, population, worlds);
}

std::size_t Recipe::n_frames() const {
    return n_sessions() * static_cast<std::size_t>(condition.frames);
}

std::size_t Recipe::codes_per_frame() const {
    return static_cast<std::size_t>(radar.chirps_per_frame) * radar.rx.size() *
           static_cast<std::size_t>(radar.chirp.n_samples) *
           (radar.receiver.complex_samples ? 2 : 1);
}

Recipe read_recipe(const RecipeRequest& request, const Catalogue& catalogue) {
    Section root = Section::read(request.file);
    Recipe recipe;
    recipe.name = request.file.stem().string();
    recipe.source = root.source();
    if (root.has_section("training")) {
        take_study(recipe, request, catalogue);
    } else {
        if (!request.condition.empty())
            throw InputError(
                format("--condition {}: {} is a dataset, which has no conditions; "
                       "leave it out",
                       request.condition, request.file.string()));
        take_dataset(recipe, root, catalogue);
    }
    if (request.seed) recipe.seed = *request.seed;
    if (request.worlds) recipe.worlds = *request.worlds;
    if (!request.store.empty()) {
        try {
            recipe.stored = stored_forms(request.store);
        } catch (const InputError& error) {
            throw InputError(
                format("--store: {}; use some of adc, profiles and features", error.what()));
        }
    }
    if (recipe.condition.geometry_law)
        recipe.condition.geometry_law->n_sessions =
            recipe.worlds * recipe.condition.sessions_per_class();
    check_forms(recipe);
    recipe.text = recipe_text(recipe, root, catalogue);
    return recipe;
}

Bench bench_of(const Recipe& recipe, const Library& materials) {
    return {.radar = recipe.radar,
            .population = recipe.population,
            .materials = materials,
            .nominal_height_m = recipe.nominal_height_m,
            .seed = recipe.seed,
            .solver = recipe.solver};
}

}  // namespace specula
