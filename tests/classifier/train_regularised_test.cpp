#include <cmath>
#include <set>

#include "classifier/adam.hpp"
#include "classifier/metrics.hpp"
#include "classifier/predict.hpp"
#include "classifier/train.hpp"
#include "classifier/training_speed.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/classifier/golden_run.hpp"
#include "tests/classifier/trained_blobs.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::string provenance(const Model& model, const std::string& what) {
    for (const auto& [key_, value] : model.provenance)
        if (key_ == what) return value;
    return "(none)";
}

TEST_CASE("AdamW shrinks weights by the rate times the decay, and nothing else", "[adam]") {
    // Without a gradient only the decay moves anything: (1 - 0.01 * 0.1) ^ 100.
    GoldenRun<double> run(true);
    const MlpNetwork<double> before = run.network;
    auto none = run.workspace.gradient;
    for (auto& layer : none) {
        layer.weight.setZero();
        layer.bias.setZero();
        layer.gamma.setZero();
        layer.beta.setZero();
    }
    run.adam.learning_rate = 0.01;
    run.adam.weight_decay = 0.1;
    for (int i = 0; i < 100; ++i) adam_step(none, run.adam, run.network);
    const double kept = std::pow(0.999, 100);
    for (std::size_t l = 0; l < before.layers.size(); ++l) {
        CHECK(relative_difference(run.network.layers[l].weight, kept * before.layers[l].weight) <
              1e-13);
        CHECK(run.network.layers[l].bias == before.layers[l].bias);
        CHECK(run.network.layers[l].gamma == before.layers[l].gamma);
        CHECK(run.network.layers[l].beta == before.layers[l].beta);
    }
}

TEST_CASE("a step of AdamW is the step of Adam after the decay", "[adam]") {
    GoldenRun<double> plain(false), decayed(false);
    for (auto& layer : plain.network.layers) layer.weight *= 1.0 - 1e-3 * 0.5;
    decayed.adam.weight_decay = 0.5;
    plain.load();
    decayed.load();
    // The same gradient for both: that of the shrunk network.
    forward_train(plain.network, plain.workspace);
    backward(plain.network, plain.workspace);
    const auto gradient = plain.workspace.gradient;
    adam_step(gradient, plain.adam, plain.network);
    adam_step(gradient, decayed.adam, decayed.network);
    for (std::size_t l = 0; l < 3; ++l)
        CHECK(relative_difference(decayed.network.layers[l].weight,
                                  plain.network.layers[l].weight) < 1e-15);
}

/// The loss of soft targets by its definition, from the logits that forward_train left.
double plain_loss(const MlpWorkspace<double>& w, double smoothing, double share) {
    double loss = 0.0;
    const Eigen::Index n_classes = w.logits.rows();
    for (Eigen::Index j = 0; j < w.n_examples; ++j) {
        const double whole = std::log(w.logits.col(j).array().exp().sum());
        for (Eigen::Index c = 0; c < n_classes; ++c) {
            double target = smoothing / static_cast<double>(n_classes);
            if (c == w.label[std::size_t(j)]) target += (1.0 - smoothing) * share;
            if (!w.other_label.empty() && c == w.other_label[std::size_t(j)])
                target += (1.0 - smoothing) * (1.0 - share);
            loss -= target * (w.logits(c, j) - whole) / static_cast<double>(w.n_examples);
        }
    }
    return loss;
}

TEST_CASE("smoothed and mixed losses are the cross-entropy with soft targets", "[mixup]") {
    GoldenRun<double> run(false);
    run.workspace.smoothing = 0.1;
    const auto& batch = run.order[0];
    load_batch<double>(run.inputs, run.labels, batch, run.workspace);
    const double smoothed = forward_train(run.network, run.workspace);
    CHECK(smoothed == Approx(plain_loss(run.workspace, 0.1, 1.0)).epsilon(1e-13));

    const std::vector<std::uint32_t> other(batch.rbegin(), batch.rend());
    load_mixed_batch<double>(run.inputs, run.labels,
                             {.chosen = batch, .other = other, .share = 0.3}, run.workspace);
    const double mixed = forward_train(run.network, run.workspace);
    CHECK(mixed == Approx(plain_loss(run.workspace, 0.1, 0.3)).epsilon(1e-13));
    const Matrix<double> between = 0.3 * run.inputs.col(batch[4]) + 0.7 * run.inputs.col(other[4]);
    CHECK(relative_difference(run.workspace.input.col(4), between) < 1e-15);

    // The gradient of the logits is the slope of that loss.
    const double kept = run.network.layers[2].bias(1);
    backward(run.network, run.workspace);
    const double slope = run.workspace.gradient[2].bias(1);
    run.network.layers[2].bias(1) = kept + 1e-5;
    const double above = forward_train(run.network, run.workspace);
    run.network.layers[2].bias(1) = kept - 1e-5;
    const double below = forward_train(run.network, run.workspace);
    CHECK(slope == Approx((above - below) / 2e-5).margin(1e-9));
}

TEST_CASE("every regulariser and schedule still learns clouds that lie apart", "[train]") {
    const auto options = GENERATE(values<TrainOptions>({{.schedule = Schedule::cosine},
                                                        {.schedule = Schedule::one_cycle},
                                                        {.weight_decay = 0.01},
                                                        {.label_smoothing = 0.1},
                                                        {.mixup = 0.2},
                                                        {.precision = Precision::float64},
                                                        {.schedule = Schedule::one_cycle,
                                                         .weight_decay = 0.01,
                                                         .label_smoothing = 0.1,
                                                         .mixup = 0.4}}));
    TrainOptions all = options;
    all.learning_rate = 0.01;
    all.batch_size = 32;
    const Model model = train(draw({}), all, training_key);
    CHECK(f1_on(model, draw({.item = 1})) > 0.99);  // a point errs with probability 2e-5
    CHECK(train(draw({}), all, training_key).output.weight ==
          model.output.weight);  // the same bytes
}

double mean_confidence(const Model& model, const FeatureTable& rows) {
    double sum = 0.0;
    for (const float p : predict(fold(model), rows).probability) sum += double(p);
    return sum / double(rows.size());
}

TEST_CASE("label smoothing makes a model less sure, by about the share it spreads", "[train]") {
    const FeatureTable rows = draw({.n_rows = 2000, .distance = 12.0});
    const TrainOptions plain{.epochs = 60, .learning_rate = 0.01};
    TrainOptions smoothed = plain;
    smoothed.label_smoothing = 0.3;
    CHECK(mean_confidence(train(rows, plain, training_key), rows) > 0.99);
    // The best answer to a target of 0.7 + 0.3 / 3 is that target.
    CHECK(mean_confidence(train(rows, smoothed, training_key), rows) == Approx(0.8).margin(0.03));
}

TEST_CASE("weight decay makes weights smaller", "[train]") {
    const TrainOptions plain{.epochs = 60, .learning_rate = 0.01};
    TrainOptions decayed = plain;
    decayed.weight_decay = 0.5;
    const auto size = [](const Model& model) {
        double sum = 0.0;
        for (const float weight : model.output.weight) sum += double(weight) * double(weight);
        return sum;
    };
    CHECK(size(train(draw({}), decayed, training_key)) <
          0.7 * size(train(draw({}), plain, training_key)));
}

/// Noise to be learnt by heart: patience must end it.
FeatureTable noise(std::uint32_t item) {
    FeatureTable rows = draw({.n_rows = 240, .n_features = 8, .distance = 0.0, .item = item});
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows.session[i] = 3 * static_cast<std::int32_t>(i / 24) + rows.label[i];
    return rows;
}

TEST_CASE("patience ends a training that only learns noise, and keeps its best", "[train]") {
    const TrainOptions options{.hidden = {32, 32},
                               .epochs = 300,
                               .batch_size = 16,
                               .learning_rate = 0.01,
                               .patience = 5,
                               .held_out = 0.3};
    TrainingCurve curve;
    const Model model = train(noise(0), options, training_key, {.curve = &curve});
    REQUIRE(curve.loss.size() == curve.held_out_loss.size());
    CHECK(curve.loss.size() < 60);
    CHECK(static_cast<int>(curve.loss.size()) == curve.best_epoch + 5);
    const auto best = static_cast<std::size_t>(curve.best_epoch - 1);
    for (const double loss : curve.held_out_loss) CHECK(curve.held_out_loss[best] <= loss);
    CHECK(provenance(model, "kept epoch") ==
          std::to_string(curve.best_epoch) + " of " + std::to_string(curve.loss.size()));
}

TEST_CASE("the kept network is that of the best epoch, on rows given from outside too", "[train]") {
    const FeatureTable rows = noise(0), held_out = noise(1);
    TrainOptions options{.hidden = {16}, .epochs = 50, .batch_size = 16, .learning_rate = 0.01};
    options.patience = 4;
    TrainingCurve curve;
    const Model kept = train(rows, options, training_key, {.held_out = &held_out, .curve = &curve});
    options.patience = 0;
    options.epochs = curve.best_epoch;  // the same steps, and no more of them
    const Model again = train(rows, options, training_key);
    CHECK(again.output.weight == kept.output.weight);
    CHECK(provenance(kept, "training rows") == "240");
}

TEST_CASE("in double and in float, training comes to the same score and near weights", "[train]") {
    TrainOptions options{.hidden = {}, .epochs = 20};  // no ReLU, so no kink parts them
    const Model in_float = train(draw({}), options, training_key);
    options.precision = Precision::float64;
    const Model in_double = train(draw({}), options, training_key);
    CHECK(provenance(in_double, "precision") == "float64");
    for (std::size_t i = 0; i < in_float.output.weight.size(); ++i)
        CHECK(in_float.output.weight[i] == Approx(in_double.output.weight[i]).margin(1e-5));
}

TEST_CASE("a model's provenance names options, stream, loss and version", "[train]") {
    const Model model = train(draw({}),
                              {.hidden = {8},
                               .epochs = 2,
                               .schedule = Schedule::one_cycle,
                               .weight_decay = 0.05,
                               .convolution = {4}},
                              training_key);
    CHECK(provenance(model, "optimiser") == "adamw");
    CHECK(provenance(model, "schedule") == "one-cycle");
    CHECK(provenance(model, "weight decay") == "0.05");
    CHECK(provenance(model, "convolution") == "[4] of 3");
    CHECK(provenance(model, "stream") == "seed 5, train test, world 0, item 0");
    CHECK(std::stod(provenance(model, "loss of the last epoch, nats")) > 0.0);
    CHECK(provenance(model, "version") != "(none)");
    CHECK(provenance(model, "mixup") == "(none)");
}

TEST_CASE("rows from which nothing can be learnt are refused, with a way out", "[train]") {
    FeatureTable rows = draw({.n_rows = 20});
    FeatureTable single = rows;
    single.label.assign(rows.size(), 2);
    CHECK(problem_of(single, {}) ==
          "training set: all rows are of class \"cloud 2\"; give examples of two or more classes");
    FeatureTable constant = rows;
    constant.features.assign(rows.features.size(), 3.5f);
    CHECK(problem_of(constant, {}) ==
          "features: every one has the same value in all rows; choose other bins, or look at the "
          "recording");
    rows.features[4 * 7 + 2] = std::nanf("");
    CHECK(problem_of(rows, {}) ==
          "features: number 2 of example 7 is nan; remove the example, or look at the recording");
    rows.features[4 * 7 + 2] = HUGE_VALF;
    CHECK(problem_of(rows, {}).rfind("features: number 2 of example 7 is inf", 0) == 0);
    FeatureTable two_sessions = draw({.n_rows = 20});
    for (std::size_t i = 0; i < 20; ++i) two_sessions.session[i] = two_sessions.label[i];
    two_sessions.world.assign(20, 0);
    CHECK(problem_of(two_sessions, {.patience = 3})
              .rfind("sessions: class \"cloud 0\" has 1 of them, too few to hold one out", 0) == 0);
}

TEST_CASE("regularisers and convolutions out of range are named with what would do", "[train]") {
    const FeatureTable rows = draw({});
    CHECK(problem_of(rows, {.weight_decay = -1.0}) ==
          "weight_decay = -1: is not within 0 and 1; use about 0.01");
    CHECK(problem_of(rows, {.label_smoothing = 1.0}) ==
          "label_smoothing = 1: is not within 0 and 1; use about 0.1");
    CHECK(problem_of(rows, {.mixup = 0.01}) ==
          "mixup = 0.01: is out of range; use 0, or 0.05 to 1");
    CHECK(problem_of(rows, {.hidden = {4, 4}, .convolution = {4, 4}}) ==
          "convolution = [4, 4]: too many layers with the 2 hidden ones; the firmware runs at most "
          "3 together");
    CHECK(problem_of(rows, {.hidden = {}, .convolution = {65}}) ==
          "convolution = [65]: a layer is out of range; use 1 to 64 channels");
    CHECK(problem_of(rows, {.hidden = {}, .convolution = {4}, .kernel = 2}) ==
          "kernel = 2: is even or wider than the 4 features; use 3");
    CHECK(problem_of(rows, {.patience = -1}) ==
          "patience = -1: is negative; use 0 for a fixed number of epochs, or about 10");
    CHECK(problem_of(rows, {.patience = 2, .held_out = 0.0}) ==
          "held_out = 0: nothing to be patient about; use about 0.2");
}

TEST_CASE("training is timed on the calling thread and passes a million examples a second",
          "[train]") {
    const TrainingSpeed speed = measure_training_speed({.n_rows = 2400});
    CHECK(speed.cpu_s > 0.0);
    CHECK(speed.cpu_us_per_step == Approx(128e6 / speed.examples_per_cpu_s).epsilon(1e-12));
#ifdef NDEBUG  // not under sanitizers; half of the promise, for machines under load
    CHECK(speed.examples_per_cpu_s > 5e5);
#endif
}

}  // namespace
}  // namespace specula
