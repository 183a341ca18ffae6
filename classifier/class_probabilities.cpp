#include "classifier/class_probabilities.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// ln(sum of exp(logit / temperature)), and the largest logit that it is taken around.
double log_sum_exp(std::span<const float> logits, double temperature) {
    const double largest = static_cast<double>(*std::ranges::max_element(logits));
    double sum = 0.0;
    for (const float logit : logits)
        sum += std::exp((static_cast<double>(logit) - largest) / temperature);
    return largest / temperature + std::log(sum);
}

std::size_t place_of_largest(std::span<const double> values) {
    return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
}

}  // namespace

ClassProbabilities softmax(const ClassRows<float>& logits, double temperature) {
    SPECULA_EXPECT(temperature > 0.0 && logits.n_classes > 0);
    ClassProbabilities result{.n_classes = logits.n_classes, .values = {}};
    result.values.reserve(logits.values.size());
    for (std::size_t i = 0; i < logits.size(); ++i) {
        const double whole = log_sum_exp(logits.row(i), temperature);
        for (const float logit : logits.row(i))
            result.values.push_back(std::exp(static_cast<double>(logit) / temperature - whole));
    }
    return result;
}

double negative_log_likelihood(const ClassRows<float>& logits, std::span<const std::uint8_t> truth,
                               double temperature) {
    SPECULA_EXPECT(!truth.empty() && truth.size() == logits.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        SPECULA_EXPECT(truth[i] < logits.n_classes);
        sum += log_sum_exp(logits.row(i), temperature) -
               static_cast<double>(logits.row(i)[truth[i]]) / temperature;
    }
    return sum / static_cast<double>(truth.size());
}

double brier_score(const ClassProbabilities& probabilities, std::span<const std::uint8_t> truth) {
    SPECULA_EXPECT(!truth.empty() && truth.size() == probabilities.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (std::size_t c = 0; c < probabilities.n_classes; ++c) {
            const double away = probabilities.row(i)[c] - (truth[i] == c ? 1.0 : 0.0);
            sum += away * away;
        }
    return sum / static_cast<double>(truth.size());
}

double fit_temperature(const ClassRows<float>& logits, std::span<const std::uint8_t> truth) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    const auto loss_at = [&](double log_temperature) {
        return negative_log_likelihood(logits, truth, std::exp(log_temperature));
    };
    double low = std::log(0.01), high = std::log(100.0);
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double at_left = loss_at(left), at_right = loss_at(right);
    while (high - low > 1e-6) {
        if (at_left < at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - golden * (high - low);
            at_left = loss_at(left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + golden * (high - low);
            at_right = loss_at(right);
        }
    }
    return std::exp(0.5 * (low + high));
}

Reliability reliability_of(const ClassProbabilities& probabilities,
                           std::span<const std::uint8_t> truth, int n_bins) {
    SPECULA_EXPECT(!truth.empty() && truth.size() == probabilities.size() && n_bins > 0);
    Reliability result;
    result.bins.resize(static_cast<std::size_t>(n_bins));
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const std::size_t said = place_of_largest(probabilities.row(i));
        const double confidence = probabilities.row(i)[said];
        const auto place = static_cast<std::ptrdiff_t>(std::ceil(confidence * n_bins)) - 1;
        ReliabilityBin& bin =
            result.bins[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, n_bins - 1))];
        ++bin.n;
        bin.confidence += confidence;
        bin.accuracy += said == truth[i] ? 1.0 : 0.0;
    }
    const auto n_all = static_cast<double>(truth.size());
    for (ReliabilityBin& bin : result.bins) {
        if (bin.n == 0) continue;
        const auto n = static_cast<double>(bin.n);
        result.expected_calibration_error += std::abs(bin.accuracy - bin.confidence) / n_all;
        result.mean_confidence += bin.confidence;
        result.accuracy += bin.accuracy;
        bin.confidence /= n;
        bin.accuracy /= n;
    }
    result.mean_confidence /= n_all;
    result.accuracy /= n_all;
    return result;
}

}  // namespace specula
