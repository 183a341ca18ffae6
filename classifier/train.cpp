#include "classifier/train.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "classifier/adam.hpp"
#include "classifier/input_monitor.hpp"
#include "classifier/mixing.hpp"
#include "classifier/mlp_network.hpp"
#include "classifier/session_split.hpp"
#include "classifier/standardiser.hpp"
#include "classifier/trained_model.hpp"
#include "classifier/training_rows.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"

namespace specula {

namespace {

/// (feature, example), with the float arithmetic of fw_mlp.
template <typename Scalar>
Matrix<Scalar> standardised(const FeatureTable& rows, const Standardiser& standardiser) {
    Matrix<Scalar> inputs(static_cast<Eigen::Index>(rows.n_features),
                          static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t f = 0; f < rows.n_features; ++f)
            inputs(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(i)) =
                (rows.row(i)[f] - standardiser.mean[f]) * standardiser.scale[f];
    return inputs;
}

void shuffle(std::span<std::uint32_t> order, Stream& stream) {
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[stream.below(static_cast<std::uint32_t>(i))]);
}

/// Examples as the network sees them.
template <typename Scalar>
struct Examples {
    Matrix<Scalar> inputs;  // (feature, example)
    std::span<const std::uint8_t> label;
};

/// Mean cross-entropy of a network that has been trained, in nats.
template <typename Scalar>
double loss_of(const MlpNetwork<Scalar>& network, const Examples<Scalar>& examples) {
    const Matrix<Scalar> logits = eval_logits(network, examples.inputs);
    double loss = 0.0;
    for (Eigen::Index j = 0; j < logits.cols(); ++j) {
        const double largest = static_cast<double>(logits.col(j).maxCoeff());
        const auto own = examples.label[static_cast<std::size_t>(j)];
        loss -= static_cast<double>(logits(own, j)) - largest;
        loss += std::log((logits.col(j).template cast<double>().array() - largest).exp().sum());
    }
    return loss / static_cast<double>(logits.cols());
}

/// One training under way.
template <typename Scalar>
class Training {
  public:
    Training(const TrainOptions& options, const Examples<Scalar>& examples, Stream& stream,
             MlpNetwork<Scalar>& network)
        : options_(options),
          examples_(examples),
          stream_(stream),
          network_(network),
          n_batches_(batch_count(examples.label.size(), options)),
          workspace_(network, static_cast<Eigen::Index>((examples.label.size() + n_batches_ - 1) /
                                                        n_batches_)),
          adam_(network),
          order_(examples.label.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        workspace_.smoothing = options.label_smoothing;
        adam_.weight_decay = options.weight_decay;
    }

    /// Returns the mean loss over its batches.
    double epoch() {
        const std::size_t n = order_.size();
        shuffle(order_, stream_);
        double loss = 0.0;
        for (std::size_t b = 0; b < n_batches_; ++b) {
            const std::size_t begin = b * n / n_batches_;
            const std::size_t end = (b + 1) * n / n_batches_;
            load(std::span(order_).subspan(begin, end - begin));
            loss += forward_train(network_, workspace_) / static_cast<double>(n_batches_);
            backward(network_, workspace_);
            adam_.learning_rate = learning_rate_at(
                {.schedule = options_.schedule,
                 .peak = options_.learning_rate,
                 .step = adam_.n_steps,
                 .n_steps = options_.epochs * static_cast<std::int64_t>(n_batches_)});
            adam_step(workspace_.gradient, adam_, network_);
        }
        return loss;
    }

  private:
    static std::size_t batch_count(std::size_t n, const TrainOptions& options) {
        const auto size = static_cast<std::size_t>(options.batch_size);
        return std::max<std::size_t>(1, (n + size / 2) / size);
    }

    void load(std::span<const std::uint32_t> batch) {
        if (options_.mixup == 0.0) {
            load_batch<Scalar>(examples_.inputs, examples_.label, batch, workspace_);
            return;
        }
        other_.assign(batch.begin(), batch.end());
        shuffle(other_, stream_);
        load_mixed_batch<Scalar>(
            examples_.inputs, examples_.label,
            {.chosen = batch, .other = other_, .share = mixing_share(options_.mixup, stream_)},
            workspace_);
    }

    const TrainOptions& options_;
    const Examples<Scalar>& examples_;
    Stream& stream_;
    MlpNetwork<Scalar>& network_;
    std::size_t n_batches_;
    MlpWorkspace<Scalar> workspace_;
    Adam<Scalar> adam_;
    std::vector<std::uint32_t> order_, other_;
};

/// Trains in place; with patience, ends with the network of the best epoch.
template <typename Scalar>
void fit(Training<Scalar>& training, const TrainOptions& options, const Examples<Scalar>* held_out,
         MlpNetwork<Scalar>& network, std::atomic<std::size_t>* epochs_done, TrainingCurve& curve) {
    double lowest_loss = std::numeric_limits<double>::infinity();
    MlpNetwork<Scalar> best = network;
    for (int epoch = 1; epoch <= options.epochs; ++epoch) {
        curve.loss.push_back(training.epoch());
        if (epochs_done) ++*epochs_done;
        curve.best_epoch = held_out ? curve.best_epoch : epoch;
        if (!held_out) continue;
        curve.held_out_loss.push_back(loss_of(network, *held_out));
        if (curve.held_out_loss.back() < lowest_loss) {
            lowest_loss = curve.held_out_loss.back();
            curve.best_epoch = epoch;
            best = network;
        }
        if (epoch - curve.best_epoch < options.patience) continue;
        if (epochs_done) *epochs_done += static_cast<std::size_t>(options.epochs - epoch);
        break;
    }
    if (held_out) network = best;
}

template <typename Scalar>
Model fitted(const SessionSplit& rows, const Standardiser& standardiser,
             const TrainOptions& options, Stream& stream, const Watched& watched,
             TrainingCurve& curve) {
    MlpNetwork<Scalar> network =
        initial_network<Scalar>({.n_features = static_cast<int>(rows.training.n_features),
                                 .channels = options.convolution,
                                 .kernel = options.kernel,
                                 .hidden = options.hidden,
                                 .n_classes = static_cast<int>(rows.training.class_names.size())},
                                stream);
    const Examples<Scalar> examples{standardised<Scalar>(rows.training, standardiser),
                                    rows.training.label};
    const Examples<Scalar> held_out{standardised<Scalar>(rows.held_out, standardiser),
                                    rows.held_out.label};
    Training<Scalar> training(options, examples, stream, network);
    fit(training, options, rows.held_out.size() > 0 ? &held_out : nullptr, network,
        watched.epochs_done, curve);
    if (!std::isfinite(curve.loss.back()) || !is_finite(network) || curve.best_epoch == 0)
        throw InputError(format("learning_rate = {}: training diverged; use a smaller one",
                                options.learning_rate));
    return model_of(network);
}

SessionSplit parted(const FeatureTable& rows, const TrainOptions& options, const StreamKey& key,
                    const Watched& watched) {
    if (options.patience == 0) return {.training = rows, .held_out = {}};
    if (watched.held_out) {
        SPECULA_EXPECT(watched.held_out->n_features == rows.n_features &&
                       watched.held_out->class_names == rows.class_names);
        check_finite(*watched.held_out);
        return {.training = rows, .held_out = *watched.held_out};
    }
    StreamKey own = key;
    own.purpose = "held-out sessions";
    return hold_out_sessions(rows, options.held_out, own);
}

std::vector<std::pair<std::string, std::string>> provenance_of(const SessionSplit& rows,
                                                               const TrainOptions& options,
                                                               const StreamKey& key,
                                                               const TrainingCurve& curve) {
    std::vector<std::pair<std::string, std::string>> provenance{
        {"training rows", format("{}", rows.training.size())}};
    for (const auto& option : option_list(options)) provenance.push_back(option);
    provenance.emplace_back("stream", format("seed {}, {}, world {}, item {}", key.seed,
                                             key.purpose, key.world, key.item));
    provenance.emplace_back("loss of the last epoch, nats", format("{:.6g}", curve.loss.back()));
    if (!curve.held_out_loss.empty()) {
        const auto best = static_cast<std::size_t>(curve.best_epoch);
        provenance.emplace_back("held-out rows", format("{}", rows.held_out.size()));
        provenance.emplace_back("kept epoch", format("{} of {}", best, curve.loss.size()));
        provenance.emplace_back("held-out loss of the kept epoch, nats",
                                format("{:.6g}", curve.held_out_loss[best - 1]));
    }
    provenance.emplace_back("version", program_version);
    return provenance;
}

}  // namespace

Model train(const FeatureTable& rows, const TrainOptions& options, const StreamKey& key,
            const Watched& watched) {
    SPECULA_EXPECT(rows.n_features > 0);
    check_options(options, rows.n_features);
    check_training_rows(rows);
    const SessionSplit split = parted(rows, options, key, watched);
    const Standardiser standardiser = fit_standardiser(split.training);
    Stream stream(key);
    TrainingCurve curve;
    Model model = options.precision == Precision::float64
                      ? fitted<double>(split, standardiser, options, stream, watched, curve)
                      : fitted<float>(split, standardiser, options, stream, watched, curve);
    model.extractor = rows.extractor;
    model.class_names = rows.class_names;
    model.input_mean = standardiser.mean;
    model.input_scale = standardiser.scale;
    model.monitor = fit_input_monitor(split.training);
    model.provenance = provenance_of(split, options, key, curve);
    if (watched.curve) *watched.curve = std::move(curve);
    return model;
}

}  // namespace specula
