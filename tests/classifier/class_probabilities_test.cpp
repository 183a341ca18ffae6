#include "classifier/class_probabilities.hpp"

#include <cmath>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

/// Logits of examples whose truth is drawn from their own softmax at `temperature`.
struct Drawn {
    std::vector<float> logits;
    std::vector<std::uint8_t> truth;
    ClassRows<float> rows() const { return {.values = logits, .n_classes = 4}; }
};

Drawn drawn(int n, double temperature) {
    Stream stream({.seed = 9, .purpose = "probabilities test"});
    Drawn result;
    for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        std::vector<double> odds;
        for (int c = 0; c < 4; ++c) {
            result.logits.push_back(static_cast<float>(2.0 * stream.normal()));
            odds.push_back(std::exp(static_cast<double>(result.logits.back()) / temperature));
            sum += odds.back();
        }
        double left = stream.uniform() * sum;
        std::uint8_t c = 0;
        while (c < 3 && (left -= odds[c]) > 0.0) ++c;
        result.truth.push_back(c);
    }
    return result;
}

TEST_CASE("likelihood and Brier score are their definitions, summed plainly", "[probability]") {
    const Drawn data = drawn(300, 1.0);
    const ClassProbabilities p = softmax(data.rows(), 1.7);
    double likelihood = 0.0, brier = 0.0;
    for (std::size_t i = 0; i < data.truth.size(); ++i) {
        double sum = 0.0, total = 0.0;
        for (std::size_t c = 0; c < 4; ++c)
            sum += std::exp(static_cast<double>(data.logits[4 * i + c]) / 1.7);
        for (std::size_t c = 0; c < 4; ++c) {
            const double q = std::exp(static_cast<double>(data.logits[4 * i + c]) / 1.7) / sum;
            REQUIRE(p.row(i)[c] == Approx(q).epsilon(1e-13));
            brier += (q - (c == data.truth[i])) * (q - (c == data.truth[i])) / 300.0;
            total += p.row(i)[c];
        }
        CHECK(total == Approx(1.0).epsilon(1e-14));
        likelihood -= std::log(p.row(i)[data.truth[i]]) / 300.0;
    }
    CHECK(negative_log_likelihood(data.rows(), data.truth, 1.7) ==
          Approx(likelihood).epsilon(1e-12));
    CHECK(brier_score(p, data.truth) == Approx(brier).epsilon(1e-12));
}

TEST_CASE("being sure and wrong costs the logits' distance, not infinity", "[probability]") {
    const std::vector<float> logits{5000.0f, 0.0f};
    const std::vector<std::uint8_t> truth{1};
    const ClassRows<float> rows{.values = logits, .n_classes = 2};
    CHECK(negative_log_likelihood(rows, truth) == 5000.0);
    CHECK(brier_score(softmax(rows), truth) == 2.0);
}

TEST_CASE("the temperature that made the truth is found again", "[probability]") {
    const double temperature = GENERATE(0.5, 1.0, 3.0);
    const Drawn data = drawn(20000, temperature);
    const double fitted = fit_temperature(data.rows(), data.truth);
    // Standard error of a maximum-likelihood estimate from 20,000 draws: about 1 % here.
    CHECK(fitted == Approx(temperature).epsilon(0.05));
    const double least = negative_log_likelihood(data.rows(), data.truth, fitted);
    CHECK(least <= negative_log_likelihood(data.rows(), data.truth, fitted * 1.001));
    CHECK(least <= negative_log_likelihood(data.rows(), data.truth, fitted / 1.001));
}

TEST_CASE("confidence that is met is calibrated; four times the logits are not", "[probability]") {
    const Drawn data = drawn(40000, 1.0);
    const Reliability good = reliability_of(softmax(data.rows()), data.truth);
    // Each bin's accuracy has a standard error of sqrt(p q / n); their mean over 15 bins of 40,000
    // draws is below sqrt(15 * 0.25 / 40000) = 0.0097.
    CHECK(good.expected_calibration_error < 0.0097);
    CHECK(good.mean_confidence == Approx(good.accuracy).margin(0.01));
    const Reliability sharp = reliability_of(softmax(data.rows(), 0.25), data.truth);
    CHECK(sharp.expected_calibration_error > 0.1);
    CHECK(sharp.accuracy == good.accuracy);
}

TEST_CASE("reliability of four examples in two bins, by hand", "[probability]") {
    // Confidences 0.5 (lower bin, edges belong below), 0.6, 0.8, 1.0; right: the 2nd and the 4th.
    const ClassProbabilities p{.n_classes = 2, .values = {0.5, 0.5, 0.4, 0.6, 0.8, 0.2, 1.0, 0.0}};
    const std::vector<std::uint8_t> truth{1, 1, 1, 0};
    const Reliability found = reliability_of(p, truth, 2);
    CHECK((found.bins[0].n == 1 && found.bins[1].n == 3));
    CHECK(found.bins[0].accuracy == 0.0);
    CHECK(found.bins[1].confidence == Approx(0.8));
    CHECK(found.bins[1].accuracy == Approx(2.0 / 3.0));
    CHECK(found.expected_calibration_error ==
          Approx(0.25 * 0.5 + 0.75 * std::abs(2.0 / 3.0 - 0.8)).epsilon(1e-14));
}

}  // namespace
}  // namespace specula
