#include "classifier/assessment.hpp"

#include <cmath>

#include "classifier/metrics.hpp"
#include "classifier/train.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"

namespace specula {
namespace {

const Assessing how{
    .merged_class = {0, 0, 1},
    .temperature = 2.0,
    .resampling = {.n_resamples = 200, .key = {.seed = 1, .purpose = "assessment"}}};

struct Answered {
    FeatureTable training = draw({.distance = 2.0});
    Model model = train(training, {.epochs = 20, .learning_rate = 0.01},
                        {.seed = 5, .purpose = "assessment test"});
    FeatureTable rows = draw({.n_rows = 500, .distance = 2.0, .item = 1});
    Predictions answers = predict(fold(model), rows);
};

TEST_CASE("an assessment holds what each measure says by itself", "[assessment]") {
    const Answered asked;
    const Assessment found = assess(asked.rows, asked.answers, how);
    const Confusion counts = confusion_of(asked.rows.label, asked.answers.label, 3);
    CHECK((found.n_rows == 500 && found.n_sessions == 10 && found.n_worlds == 2));
    CHECK(found.confusion.counts == counts.counts);
    CHECK(found.accuracy > 0.6);
    CHECK(found.accuracy == Approx(found.reliability.accuracy));
    CHECK(1.0 - found.accuracy == Approx(found.risk_coverage.risk.back()));
    double mean = 0.0;  // worlds are the odd and the even rows
    for (int world = 0; world < 2; ++world) {
        std::vector<std::uint8_t> truth, said;
        for (std::size_t i = 0; i < 500; ++i)
            if (asked.rows.world[i] == world) {
                truth.push_back(asked.rows.label[i]);
                said.push_back(asked.answers.label[i]);
            }
        mean += macro_f1(confusion_of(truth, said, 3)) / 2.0;
    }
    CHECK(found.macro_f1.mean == Approx(mean).epsilon(1e-12));
    CHECK((found.macro_f1.low <= mean && mean <= found.macro_f1.high));
    CHECK(found.macro_f1_merged.mean > found.macro_f1.mean);  // two of three errors are forgiven
    const ClassRows<float> logits{.values = asked.answers.logits, .n_classes = 3};
    CHECK(found.negative_log_likelihood_scaled ==
          negative_log_likelihood(logits, asked.rows.label, 2.0));
    CHECK(found.reliability_scaled.mean_confidence < found.reliability.mean_confidence);
    CHECK(found.coverage_at_5_percent_risk < 1.0);
    CHECK(found.area_under_risk_coverage < 1.0 - found.accuracy);  // doubt says something
}

TEST_CASE("worlds that lack a class of the data are counted", "[assessment]") {
    Answered asked;
    CHECK(assess(asked.rows, asked.answers, how).n_worlds_short_of_classes == 0);
    const FeatureTable fewer = select_rows_where(asked.rows, [&](std::size_t i) {
        return asked.rows.world[i] == 0 || asked.rows.label[i] != 1;
    });
    const Predictions answers = predict(fold(asked.model), fewer);
    CHECK(assess(fewer, answers, how).n_worlds_short_of_classes == 1);
}

TEST_CASE("a departure finds the feature that moved, by every measure", "[assessment]") {
    const Answered asked;
    FeatureTable moved = draw({.n_rows = 400, .distance = 2.0, .item = 2});
    for (std::size_t i = 0; i < moved.size(); ++i) moved.features[4 * i + 3] += 4.0f;
    const Predictions answers = predict(fold(asked.model), moved);
    const Prototypes prototypes =
        fit_prototypes(asked.training, {}, {.seed = 1, .purpose = "assessment test"});
    const Departure found = departure_from({.rows = asked.rows,
                                            .predictions = asked.answers,
                                            .spread = &*asked.model.monitor,
                                            .prototypes = &prototypes},
                                           {.rows = moved,
                                            .predictions = answers,
                                            .spread = &*asked.model.monitor,
                                            .prototypes = &prototypes});
    CHECK(found.monitor == monitor_names());
    CHECK(found.detection[3].auroc > 0.95);  // Mahalanobis
    CHECK(found.detection[4].auroc > 0.9);
    CHECK(found.mean_shift[3] == Approx(4.0).epsilon(0.1));
    for (std::size_t f = 0; f < 3; ++f) {
        CHECK(found.mean_shift[f] < 0.3);
        CHECK(found.population_stability[f] < 0.25);
    }
    CHECK(found.population_stability[3] > 1.0);
    CHECK(found.mean_discrepancy > 0.05);

    const Departure less = departure_from({.rows = asked.rows, .predictions = asked.answers},
                                          {.rows = moved, .predictions = answers});
    CHECK(less.monitor == std::vector<std::string>{"max-logit", "msp", "energy"});
}

}  // namespace
}  // namespace specula
