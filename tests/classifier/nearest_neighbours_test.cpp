#include "classifier/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

TEST_CASE("the nearest row's class is that of a plain search in double", "[neighbours]") {
    const FeatureTable rows = draw({.n_rows = 200, .distance = 1.0});
    const FeatureTable asked = draw({.n_rows = 100, .distance = 1.0, .item = 1});
    const Standardiser scale = fit_standardiser(rows);
    const Predictions answers = NearestNeighbours(rows, 1).predict(asked);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        double nearest = 1e30;
        std::uint8_t label = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            double squared = 0.0;
            for (std::size_t f = 0; f < 4; ++f) {
                const double away =
                    double(asked.row(i)[f] - rows.row(k)[f]) * double(scale.scale[f]);
                squared += away * away;
            }
            if (squared < nearest) label = rows.label[k];
            nearest = std::min(nearest, squared);
        }
        CHECK(answers.label[i] == label);
        CHECK(answers.probability[i] == Approx((1.0 + 1.0 / 3.0) / 2.0));
    }
}

TEST_CASE("five votes: the most win, and probabilities add up to 1", "[neighbours]") {
    FeatureTable rows;
    rows.n_features = 1;
    rows.class_names = {"a", "b"};
    rows.features = {0.0f, 0.1f, 0.2f, 0.3f, 0.4f, 9.0f};
    rows.label = {0, 1, 1, 0, 1, 0};
    rows.world = rows.session = std::vector<std::int32_t>(6, 0);
    FeatureTable asked = rows;
    asked.features = {0.0f, 0.1f, 0.2f, 0.3f, 0.4f, 0.05f};
    const Predictions answers = NearestNeighbours(rows).predict(asked);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(answers.label[i] == 1);  // three of five, though the first is nearest to itself
        CHECK(answers.probability[i] == Approx(3.5 / 6.0));
        CHECK(std::exp(answers.logits[2 * i]) + std::exp(answers.logits[2 * i + 1]) == Approx(1.0));
    }
    CHECK(message_of([&] {
              rows.label.assign(6, 1);
              return NearestNeighbours(rows).predict(asked).size();
          }).rfind("training set: all rows are of class \"b\"", 0) == 0);
}

TEST_CASE("prototypes settle on the clouds that there are", "[neighbours]") {
    // Two clouds in one class, at 0 and 20 along a feature of spread about 10.
    FeatureTable rows = draw({.n_rows = 400, .n_classes = 1, .n_features = 2, .distance = 0.0});
    for (std::size_t i = 0; i < rows.size(); i += 2) rows.features[2 * i] += 20.0f;
    const Prototypes prototypes =
        fit_prototypes(rows, {.per_class = 2}, {.seed = 1, .purpose = "prototype test"});
    REQUIRE(prototypes.centre.cols() == 2);
    std::vector<double> places;
    for (Eigen::Index c = 0; c < 2; ++c)
        places.push_back(double(prototypes.centre(0, c) / prototypes.standardiser.scale[0] +
                                prototypes.standardiser.mean[0]));
    std::sort(places.begin(), places.end());
    CHECK(places[0] == Approx(0.0).margin(0.3));  // 200 rows: 4 standard errors
    CHECK(places[1] == Approx(20.0).margin(0.3));
}

TEST_CASE("distances are those from the nearest of all prototypes", "[neighbours]") {
    const FeatureTable rows = draw({});
    const StreamKey key{.seed = 1, .purpose = "prototype test"};
    const Prototypes prototypes = fit_prototypes(rows, {.per_class = 4}, key);
    CHECK(prototypes.centre.cols() == 12);
    CHECK(fit_prototypes(rows, {.per_class = 4}, key).centre == prototypes.centre);
    const auto distances = prototype_distances(prototypes, rows);
    for (std::size_t i = 0; i < rows.size(); i += 10) {
        double nearest = 1e30;
        for (Eigen::Index c = 0; c < 12; ++c) {
            double squared = 0.0;
            for (std::size_t f = 0; f < 4; ++f) {
                const double x = double((rows.row(i)[f] - prototypes.standardiser.mean[f]) *
                                        prototypes.standardiser.scale[f]);
                const double away = x - double(prototypes.centre(Eigen::Index(f), c));
                squared += away * away;
            }
            nearest = std::min(nearest, std::sqrt(squared));
        }
        CHECK(distances[i] == Approx(nearest).epsilon(1e-5));
    }
    FeatureTable far = rows;
    for (float& value : far.features) value += 50.0f;
    CHECK(prototype_distances(prototypes, far)[0] > 10.0);
}

TEST_CASE("prototypes that a model keeps measure the same distances", "[neighbours]") {
    const FeatureTable rows = draw({});
    const Prototypes prototypes = fit_prototypes(rows, {}, {.seed = 2, .purpose = "kept"});
    const InputPrototypes flat = kept(prototypes);
    CHECK(flat.centre.size() == 3 * 4 * rows.n_features);
    CHECK(flat.centre[1] == prototypes.centre(1, 0));  // feature by feature, then the next one
    CHECK(prototype_distances(prototypes_of(flat), rows) == prototype_distances(prototypes, rows));
}

}  // namespace
}  // namespace specula
