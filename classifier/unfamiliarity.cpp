#include "classifier/unfamiliarity.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "firmware/fw_monitor.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

void check_status(fw_status status, std::size_t row) {
    if (status == FW_ERR_NONFINITE)
        throw InputError(
            format("features of example {}: not finite, or too large for the monitor; look at the "
                   "recording",
                   row));
    SPECULA_EXPECT(status == FW_OK);
}

/// 1 - the largest probability, without the rounding that 1 - 0.99999999 would bring.
double doubt(std::span<const float> logits) {
    const auto largest = std::ranges::max_element(logits);
    double others = 0.0;
    for (auto logit = logits.begin(); logit != logits.end(); ++logit)
        if (logit != largest)
            others += std::exp(static_cast<double>(*logit) - static_cast<double>(*largest));
    return others / (1.0 + others);
}

double of_logits(Monitor monitor, const Predictions& predictions, std::size_t row) {
    const float* const logits = predictions.logits.data() + row * predictions.n_classes;
    const auto n = static_cast<std::uint16_t>(predictions.n_classes);
    if (monitor == Monitor::max_logit) return -static_cast<double>(fw_max_logit(logits, n));
    if (monitor == Monitor::softmax_probability) return doubt({logits, predictions.n_classes});
    float energy = 0.0f;
    check_status(fw_energy(logits, n, &energy), row);
    return static_cast<double>(energy);
}

std::vector<double> mahalanobis(const Observed& observed) {
    if (!observed.spread)
        throw InputError("monitor: the model holds none of its inputs; train it again");
    const InputMonitor& spread = *observed.spread;
    const std::size_t n = observed.rows.n_features;
    SPECULA_EXPECT(spread.mean.size() == n);
    const fw_mahalanobis view{.n_features = static_cast<std::uint16_t>(n),
                              .n_classes = static_cast<std::uint16_t>(spread.centre.size() / n),
                              .mean = spread.mean.data(),
                              .whitening = spread.whitening.data(),
                              .centre = spread.centre.data()};
    std::vector<double> scores;
    for (std::size_t i = 0; i < observed.rows.size(); ++i) {
        float squared = 0.0f;
        check_status(fw_mahalanobis_squared(&view, observed.rows.row(i).data(), &squared), i);
        scores.push_back(static_cast<double>(squared));
    }
    return scores;
}

}  // namespace

const std::vector<std::string>& monitor_names() {
    static const std::vector<std::string> names{"max-logit", "msp", "energy", "mahalanobis",
                                                "prototypes"};
    return names;
}

std::vector<double> unfamiliarity(Monitor monitor, const Observed& observed) {
    SPECULA_EXPECT(observed.predictions.size() == observed.rows.size());
    if (monitor == Monitor::mahalanobis) return mahalanobis(observed);
    if (monitor == Monitor::prototypes) {
        SPECULA_EXPECT(observed.prototypes);
        return prototype_distances(*observed.prototypes, observed.rows);
    }
    std::vector<double> scores;
    for (std::size_t i = 0; i < observed.rows.size(); ++i)
        scores.push_back(of_logits(monitor, observed.predictions, i));
    return scores;
}

}  // namespace specula
