#include "classifier/predict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"

namespace specula {
namespace {

FeatureTable random_rows(std::size_t n_rows, std::size_t n_features) {
    Stream stream({.seed = 1, .purpose = "predict test"});
    FeatureTable table;
    table.n_features = n_features;
    table.label.resize(n_rows);
    table.world.resize(n_rows);
    table.session.resize(n_rows);
    table.features = random_features(n_rows * n_features, stream);
    return table;
}

TEST_CASE("the label is the largest logit and the probability its softmax", "[predict]") {
    const Model model = random_model({6, 8, 4});
    const FeatureTable rows = random_rows(50, 6);
    const Predictions predictions = predict(fold(model), rows);
    REQUIRE(predictions.size() == 50);
    REQUIRE(predictions.logits.size() == 200);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto expected = naive_logits(model, rows.row(i));
        const auto best = std::max_element(expected.begin(), expected.end());
        double sum = 0.0;
        for (const double logit : expected) sum += std::exp(logit - *best);
        CHECK(predictions.label[i] == best - expected.begin());
        CHECK(predictions.probability[i] == Approx(1.0 / sum).epsilon(1e-5));  // float
    }
}

TEST_CASE("no rows give no predictions", "[predict]") {
    CHECK(predict(fold(random_model({6, 8, 4})), random_rows(0, 6)).size() == 0);
}

TEST_CASE("a row that is not finite is named", "[predict]") {
    FeatureTable rows = random_rows(5, 6);
    rows.features[3 * 6 + 1] = std::numeric_limits<float>::quiet_NaN();
    try {
        predict(fold(random_model({6, 8, 4})), rows);
        FAIL("accepted");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()) ==
              "features of example 3: not finite, or too large for the classifier; look at the "
              "recording");
    }
}

TEST_CASE("rows of another width are a mistake of the caller", "[predict]") {
    CHECK_THROWS_AS(predict(fold(random_model({6, 8, 4})), random_rows(5, 7)), BrokenPromise);
}

}  // namespace
}  // namespace specula
