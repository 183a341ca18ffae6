#include "tools/study/judgement.hpp"

#include <set>

#include "tests/check.hpp"

namespace specula {
namespace {

/// Rows of two worlds, each with a feature that no other row has.
FeatureTable numbered_rows(std::size_t n_per_world) {
    FeatureTable table;
    table.extractor = "range_bins";
    table.n_features = 1;
    table.class_names = {"a", "b"};
    for (std::size_t i = 0; i < 2 * n_per_world; ++i) {
        table.features.push_back(static_cast<float>(i));
        table.label.push_back(i % 2);
        table.world.push_back(i < n_per_world ? 0 : 1);
        table.session.push_back(static_cast<std::int32_t>(i / 10));
    }
    return table;
}

std::set<float> features_of(const FeatureTable& rows) {
    return {rows.features.begin(), rows.features.end()};
}

TEST_CASE("a world's rows are parted without loss and without a row on both sides", "[study]") {
    const FeatureTable all = numbered_rows(500);
    for (const int world : {0, 1}) {
        const Split split = split_world(all, world, 0.2, 7);
        CHECK(split.training.size() + split.validation.size() == 500);
        std::set<float> together = features_of(split.training);
        for (const float feature : split.validation.features)
            CHECK(together.insert(feature).second);
        CHECK(together.size() == 500);
        for (const std::int32_t of : split.training.world) CHECK(of == world);
        for (const std::int32_t of : split.validation.world) CHECK(of == world);
        // 500 draws at 0.2 spread by sqrt(500 * 0.16) = 9 rows; five times that.
        CHECK(std::abs(static_cast<double>(split.validation.size()) - 100.0) < 45.0);
    }
}

TEST_CASE("a split depends on seed and world and on nothing else", "[study]") {
    const FeatureTable all = numbered_rows(100);
    const auto held_back = [&](int world, std::uint64_t seed) {
        return split_world(all, world, 0.3, seed).validation.features;
    };
    CHECK(held_back(0, 7) == held_back(0, 7));
    CHECK(held_back(0, 7) != held_back(0, 8));
    std::vector<float> other = held_back(1, 7);
    for (float& feature : other) feature -= 100.0f;
    CHECK(held_back(0, 7) != other);
}

TEST_CASE("of two rows, each side gets one, whatever the share", "[study]") {
    for (const double share : {1e-9, 0.5, 1.0 - 1e-9}) {
        const Split split = split_world(numbered_rows(2), 0, share, 7);
        CHECK(split.training.size() == 1);
        CHECK(split.validation.size() == 1);
    }
}

TEST_CASE("each world is judged by its own model on its own rows", "[study]") {
    // Two worlds in which the same feature means the opposite class.
    FeatureTable table;
    table.extractor = "range_bins";
    table.n_features = 1;
    table.class_names = {"low", "high"};
    Stream stream({.seed = 1, .purpose = "rows"});
    for (int i = 0; i < 400; ++i) {
        const int world = i % 2, label = i / 2 % 2;
        table.features.push_back(
            static_cast<float>((label == world ? 1.0 : 9.0) + stream.normal()));
        table.label.push_back(static_cast<std::uint8_t>(label));
        table.world.push_back(world);
        table.session.push_back(0);
    }
    const RunSettings run{.seed = 7, .worlds = 2, .threads = 2, .folder = {}};
    std::vector<Split> splits{split_world(table, 0, 0.3, 7), split_world(table, 1, 0.3, 7)};
    TrainOptions options;
    options.hidden = {4};
    options.epochs = 60;
    options.batch_size = 16;
    options.learning_rate = 0.02;
    std::vector<Model> models;
    {
        Progress progress("Training", "worlds", 2);
        models = train_worlds(splits, options, run, progress);
        CHECK(progress.done() == 2);
    }
    const auto outcomes = judge(models, table, run);
    REQUIRE(outcomes.size() == 2);
    for (const WorldOutcome& world : outcomes) {
        REQUIRE(world.truth.size() == 200);
        std::size_t right = 0;
        for (std::size_t i = 0; i < world.truth.size(); ++i)
            right += world.truth[i] == world.predictions.label[i];
        CHECK(right > 190);  // eight standard deviations apart; the other world's model gets none
    }
}

TEST_CASE("what standardises the features is fitted on the training rows alone", "[study]") {
    FeatureTable table = numbered_rows(200);
    Split split = split_world(table, 0, 0.3, 7);
    const RunSettings run{.seed = 7, .worlds = 1, .threads = 1, .folder = {}};
    TrainOptions options;
    options.hidden = {4};
    options.epochs = 1;
    const auto model_of = [&] {
        Progress progress("Training", "worlds", 1);
        return train_worlds({split}, options, run, progress)[0];
    };
    const Model before = model_of();
    for (float& feature : split.validation.features) feature *= 1000.0f;
    const Model after = model_of();
    CHECK(before.input_mean == after.input_mean);
    CHECK(before.input_scale == after.input_scale);
    CHECK(before.output.weight == after.output.weight);
    double mean = 0.0;
    for (const float feature : split.training.features)
        mean += static_cast<double>(feature) / static_cast<double>(split.training.size());
    CHECK(before.input_mean[0] == Approx(mean).epsilon(1e-6));  // float
}

}  // namespace
}  // namespace specula
