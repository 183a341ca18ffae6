#include "classifier/unfamiliarity.hpp"

#include <cmath>

#include "classifier/detection.hpp"
#include "classifier/train.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

struct Judged {
    FeatureTable rows = draw({});
    Model model = train(rows, {.epochs = 20, .learning_rate = 0.01},
                        {.seed = 5, .purpose = "unfamiliarity test"});
    Prototypes prototypes = fit_prototypes(rows, {}, {.seed = 5, .purpose = "unfamiliarity test"});

    std::vector<double> scores(Monitor monitor, const FeatureTable& of) const {
        const Predictions answers = predict(fold(model), of);
        return unfamiliarity(monitor, {.rows = of,
                                       .predictions = answers,
                                       .spread = &*model.monitor,
                                       .prototypes = &prototypes});
    }
};

TEST_CASE("scores of logits are their definitions, in double", "[monitor]") {
    const Judged judged;
    const Predictions answers = predict(fold(judged.model), judged.rows);
    const auto largest = judged.scores(Monitor::max_logit, judged.rows);
    const auto doubt = judged.scores(Monitor::softmax_probability, judged.rows);
    const auto energy = judged.scores(Monitor::energy, judged.rows);
    for (std::size_t i = 0; i < judged.rows.size(); i += 7) {
        double sum = 0.0, top = -1e30;
        for (std::size_t c = 0; c < 3; ++c) {
            sum += std::exp(double(answers.logits[3 * i + c]));
            top = std::max(top, double(answers.logits[3 * i + c]));
        }
        CHECK(largest[i] == -top);
        CHECK(energy[i] == Approx(-std::log(sum)).epsilon(1e-5));
        CHECK(doubt[i] == Approx(1.0 - std::exp(top) / sum).margin(1e-12));
    }
}

TEST_CASE("inputs far from all that was trained on are told by distance", "[monitor]") {
    const Judged judged;
    const FeatureTable anew = draw({.item = 1});
    FeatureTable moved = anew;
    for (std::size_t i = 0; i < moved.size(); ++i) moved.features[4 * i + 3] += 12.0f;
    for (const Monitor monitor : {Monitor::mahalanobis, Monitor::prototypes}) {
        CAPTURE(monitor_names()[static_cast<std::size_t>(monitor)]);
        // 12 standard deviations along a feature whose own spread is 1.
        CHECK(detection_of({judged.scores(monitor, anew), judged.scores(monitor, moved)}).auroc >
              0.999);
        const Detection none =
            detection_of({judged.scores(monitor, anew), judged.scores(monitor, draw({.item = 2}))});
        CHECK(none.auroc == Approx(0.5).margin(0.1));  // 4 standard errors of 300 against 300
    }
}

TEST_CASE("Mahalanobis distances of familiar rows are those of a normal law", "[monitor]") {
    const auto scores = Judged().scores(Monitor::mahalanobis, draw({.n_rows = 2000, .item = 1}));
    double mean = 0.0;
    for (const double score : scores) mean += score / 2000.0;
    CHECK(mean == Approx(4.0).epsilon(0.1));  // chi-squared of four features; clouds 6 apart
}

TEST_CASE("a model without an input monitor says so", "[monitor]") {
    const Judged judged;
    const Predictions answers = predict(fold(judged.model), judged.rows);
    CHECK(message_of([&] {
              return unfamiliarity(Monitor::mahalanobis,
                                   {.rows = judged.rows, .predictions = answers});
          }) == "monitor: the model holds none of its inputs; train it again");
}

}  // namespace
}  // namespace specula
