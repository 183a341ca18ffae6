#include "tools/serve/rung_training.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "classifier/evaluate.hpp"
#include "classifier/extract_features.hpp"
#include "classifier/measurement.hpp"
#include "classifier/train.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/generate.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

struct Stretch {
    double first, last;

    /// Evenly, both ends included; the middle where one is asked for.
    std::vector<double> values(int n) const {
        std::vector<double> out;
        for (int i = 0; i < n; ++i)
            out.push_back(n == 1 ? 0.5 * (first + last) : first + (last - first) * i / (n - 1));
        return out;
    }
};
constexpr Stretch heights_m{0.33, 0.57};
constexpr Stretch tilts_rad{-12.0 * pi / 180.0, 12.0 * pi / 180.0};

Condition many_geometries(const Experiment& experiment, const GeometryGrid& grid, bool sensor) {
    Condition condition;
    condition.name = "many geometries";
    // Conditions of a file count from 0 upwards; these two from the end.
    condition.number = Condition::most_conditions - (sensor ? 1 : 2);
    condition.heights_m = heights_m.values(grid.heights);
    condition.tilts_rad = tilts_rad.values(grid.tilts);
    condition.tilts_sensor = sensor;
    condition.sessions = 1;
    condition.frames = experiment.training.sessions;
    return condition;
}

/// The frames of a condition as whole range profiles.
struct Recorded {
    Condition condition;
    Dataset dataset;
    FeatureTable profiles;  ///< (frame, bin)
};

Recorded record(const Bench& bench, const Condition& condition, int threads, Progress& progress) {
    Recorded recorded{.condition = condition,
                      .dataset = generate(bench, condition, 1, threads, &progress.done()),
                      .profiles = {}};
    fw_extract_config whole{.first_bin = 0,
                            .n_bins = static_cast<std::uint16_t>(recorded.dataset.n_samples / 2),
                            .window = FW_WINDOW_BLACKMAN,
                            .integration = FW_INTEGRATE_MEAN,
                            .path = FW_RANGE_FLOAT};
    recorded.profiles = extract_features(recorded.dataset, whole, threads);
    return recorded;
}

/// Whole profiles as what a rung sees of them.
FeatureTable described(const FeatureTable& profiles, const RungRecipe& recipe) {
    FeatureTable rows = profiles;
    rows.n_features = FW_DEFAULT_N_BINS;
    rows.features.clear();
    for (std::size_t i = 0; i < profiles.size(); ++i)
        for (const float value : rung_features(recipe, profiles.row(i)))
            rows.features.push_back(value);
    return rows;
}

void append(const FeatureTable& more, FeatureTable& rows) {
    rows.features.insert(rows.features.end(), more.features.begin(), more.features.end());
    rows.label.insert(rows.label.end(), more.label.begin(), more.label.end());
    rows.world.insert(rows.world.end(), more.world.begin(), more.world.end());
    rows.session.insert(rows.session.end(), more.session.begin(), more.session.end());
}

float quantile(std::vector<float>& values, double share) {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

std::vector<ClassBand> bands_of(const FeatureTable& rows) {
    std::vector<ClassBand> bands(rows.class_names.size());
    for (std::size_t label = 0; label < bands.size(); ++label)
        for (std::size_t k = 0; k < rows.n_features; ++k) {
            std::vector<float> values;
            for (std::size_t i = 0; i < rows.size(); ++i)
                if (rows.label[i] == label) values.push_back(rows.row(i)[k]);
            SPECULA_EXPECT(!values.empty());
            bands[label].low.push_back(quantile(values, 0.05));
            bands[label].middle.push_back(quantile(values, 0.5));
            bands[label].high.push_back(quantile(values, 0.95));
        }
    return bands;
}

double macro_f1(const Rung& rung, const FeatureTable& profiles) {
    const FeatureTable rows = described(profiles, *rung.recipe);
    std::vector<int> each_alone(rows.class_names.size());
    std::iota(each_alone.begin(), each_alone.end(), 0);
    const WorldOutcome outcome{rows.label, predict(rung.folded, rows)};
    return evaluate("", "", std::span(&outcome, 1),
                    {.merged_class = each_alone, .bootstrap = {.purpose = "page"}})
        .macro_f1.mean;
}

Rung train_rung(const RungRecipe& recipe, const Experiment& experiment,
                const std::vector<Recorded>& learnt, const std::vector<Recorded>& asked) {
    FeatureTable rows = described(learnt.front().profiles, recipe);
    for (std::size_t i = 1; recipe.augmented && i < learnt.size(); ++i)
        append(described(learnt[i].profiles, recipe), rows);
    TrainOptions options = experiment.classifier;
    options.epochs = experiment.full.epochs;
    Rung rung{.recipe = &recipe, .model = {}, .bands = bands_of(rows), .scores = {}, .folded = {}};
    rung.model = train(rows, options, {.seed = experiment.seed, .purpose = "training"});
    SPECULA_EXPECT(rung.model.monitor.has_value());
    rung.folded = fold(rung.model);
    for (const Recorded& each : asked)
        rung.scores.push_back({each.condition.title, macro_f1(rung, each.profiles)});
    return rung;
}

double rounded(double value, double step) {
    return std::round(value / step) * step;
}

}  // namespace

std::vector<TrainingPiece> training_pieces(const Dataset& recorded) {
    constexpr double to_mm = 1e3, to_um = 1e6, hundredth = 0.01, tenth = 0.1;
    std::vector<TrainingPiece> pieces(recorded.class_names.size());
    for (const Truth& truth : recorded.truth) {
        TrainingPiece& piece = pieces[truth.label];
        piece.name = recorded.class_names[truth.label];
        piece.thickness_mm = rounded(truth.thickness_m * to_mm, hundredth);
        piece.bow_mm = rounded(truth.bow_m * to_mm, hundredth);
        piece.roughness_um = rounded(truth.roughness_m * to_um, tenth);
        piece.correlation_mm = std::max(tenth, rounded(truth.correlation_m * to_mm, hundredth));
    }
    return pieces;
}

RungSet train_rungs(const Experiment& experiment, const Library& materials, int threads,
                    const GeometryGrid& grid) {
    const Bench bench = bench_of(experiment, materials);
    const std::vector<Condition> learnt_from{experiment.training,
                                             many_geometries(experiment, grid, true),
                                             many_geometries(experiment, grid, false)};
    std::size_t sessions = 0;
    for (const Condition& condition : learnt_from)
        sessions += session_count(condition, experiment.population, 1);
    for (const Condition& condition : experiment.conditions)
        sessions += session_count(condition, experiment.population, 1);

    std::vector<Recorded> learnt, asked;
    {
        Progress progress("Recording for the models", "sessions", sessions);
        for (const Condition& condition : learnt_from)
            learnt.push_back(record(bench, condition, threads, progress));
        for (const Condition& condition : experiment.conditions)
            asked.push_back(record(bench, condition, threads, progress));
    }
    RungSet set;
    set.pieces = training_pieces(learnt.front().dataset);
    Progress progress("Training", "models", rung_recipes.size());
    for (const RungRecipe& recipe : rung_recipes) {
        set.rungs.push_back(train_rung(recipe, experiment, learnt, asked));
        ++progress.done();
    }
    return set;
}

}  // namespace specula
