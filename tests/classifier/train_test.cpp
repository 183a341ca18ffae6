#include "classifier/train.hpp"

#include <cmath>
#include <thread>

#include "classifier/metrics.hpp"
#include "classifier/predict.hpp"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/classifier/trained_blobs.hpp"

namespace specula {
namespace {

/// All numbers of a model, to be compared bit by bit.
std::vector<float> numbers(const Model& model) {
    std::vector<float> all = model.output.weight;
    const auto add = [&](const std::vector<float>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const HiddenLayer& layer : model.hidden) {
        add(layer.weight);
        add(layer.gamma);
        add(layer.beta);
        add(layer.mean);
        add(layer.variance);
    }
    add(model.output.bias);
    add(model.input_mean);
    add(model.input_scale);
    return all;
}

TEST_CASE("clouds that lie apart are told apart, also those not seen in training", "[train]") {
    const auto hidden = GENERATE(values<std::vector<int>>({{}, {8}, {16, 16}, {8, 8, 8}}));
    const Model model =
        train(draw({}), {.hidden = hidden, .epochs = 60, .batch_size = 32, .learning_rate = 0.01},
              training_key);
    CAPTURE(hidden.size());
    // Clouds 6 sqrt(2) apart: a point errs with probability 2 * 1e-5.
    CHECK(f1_on(model, draw({.item = 1})) > 0.99);
}

TEST_CASE("rows may come sorted by class: every epoch shuffles them", "[train]") {
    const FeatureTable rows = draw({});
    std::vector<std::size_t> sorted;
    for (std::uint8_t label = 0; label < 3; ++label)
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows.label[i] == label) sorted.push_back(i);
    const TrainOptions options{.epochs = 60, .batch_size = 32, .learning_rate = 0.01};
    // Batches of one class would all be normalised to the same cloud.
    CHECK(f1_on(train(select_rows(rows, sorted), options, training_key), draw({.item = 1})) > 0.99);
}

TEST_CASE("clouds on top of each other are guessed at", "[train]") {
    const Model model = train(draw({.distance = 0.0}), {.epochs = 10}, training_key);
    const double f1 = f1_on(model, draw({.n_rows = 3000, .distance = 0.0, .item = 1}));
    CHECK(f1 < 0.37);  // one in three, and 4 standard deviations (0.0086 each) of the count
}

TEST_CASE("the same rows, options and training_key give the same bytes, in parallel too",
          "[train]") {
    const FeatureTable rows = draw({});
    const TrainOptions options{.epochs = 5};
    const Model reference = train(rows, options, training_key);
    std::vector<Model> others(3);
    std::vector<std::thread> threads;
    for (Model& other : others)
        threads.emplace_back([&] { other = train(rows, options, training_key); });
    for (std::thread& thread : threads) thread.join();
    for (const Model& other : others) CHECK(numbers(other) == numbers(reference));
}

TEST_CASE("another seed, world or item gives another model", "[train]") {
    const FeatureTable rows = draw({});
    const TrainOptions options{.epochs = 1};
    const auto reference = numbers(train(rows, options, training_key));
    StreamKey other = training_key;
    other.seed = 6;
    CHECK(numbers(train(rows, options, other)) != reference);
    other = training_key;
    other.world = 1;
    CHECK(numbers(train(rows, options, other)) != reference);
    other = training_key;
    other.item = 1;
    CHECK(numbers(train(rows, options, other)) != reference);
}

TEST_CASE("rows that do not fill the last batch are trained on without harm", "[train]") {
    const std::size_t n_rows = GENERATE(2u, 3u, 33u, 47u, 49u, 65u);
    FeatureTable rows = draw({.n_rows = n_rows});
    for (std::size_t i = 0; i < n_rows; ++i) rows.label[i] = static_cast<std::uint8_t>(i % 3);
    const Model model = train(rows, {.epochs = 3, .batch_size = 32}, training_key);
    for (const float number : numbers(model)) REQUIRE(std::isfinite(number));
}

TEST_CASE("a constant feature has no say, whatever it does later", "[train]") {
    FeatureTable rows = draw({});
    for (std::size_t i = 0; i < rows.size(); ++i) rows.features[i * 4 + 3] = 2.0f;
    const FoldedModel model = fold(train(rows, {.epochs = 5}, training_key));
    FeatureTable moved = rows;
    for (std::size_t i = 0; i < rows.size(); ++i) moved.features[i * 4 + 3] = 1e6f;
    CHECK(predict(model, moved).logits == predict(model, rows).logits);
}

TEST_CASE("a model knows its extractor, its classes and how it was trained", "[train]") {
    const Model model = train(draw({}), {.epochs = 1}, training_key);
    CHECK(model.extractor == "blobs");
    CHECK(model.class_names == std::vector<std::string>{"cloud 0", "cloud 1", "cloud 2"});
    CHECK(model.provenance.front() == std::pair<std::string, std::string>{"training rows", "300"});
    CHECK(model.hidden.size() == 2);
}

TEST_CASE("options that cannot work are named with their value and what would do", "[train]") {
    const FeatureTable rows = draw({});
    CHECK(problem_of(rows, {.hidden = {4, 4, 4, 4}}) ==
          "hidden = [4, 4, 4, 4]: too many layers; the firmware runs at most 3");
    CHECK(problem_of(rows, {.hidden = {0}}) ==
          "hidden = [0]: a layer is out of range; use 1 to 1024 units");
    CHECK(problem_of(rows, {.epochs = 0}) == "epochs = 0: too few; use 1 or more");
    CHECK(problem_of(rows, {.batch_size = 1}) == "batch_size = 1: too small; use 2 or more");
    CHECK(problem_of(rows, {.learning_rate = 0.0}) ==
          "learning_rate = 0: is not a positive number; use about 0.001");
    CHECK(problem_of(rows, {.learning_rate = 1e38}) ==
          "learning_rate = 1e+38: training diverged; use a smaller one");
    CHECK(problem_of(draw({.n_rows = 1}), {}) == "training set: has 1 rows; at least 2 are needed");
}

}  // namespace
}  // namespace specula
