#include "classifier/descriptor.hpp"
#include "classifier/folded_model.hpp"
#include "tools/study/ladder.hpp"

namespace specula {

namespace {

/// Cycles per multiplication of a network of this size, from the traced 12-16-16-5 with its
/// softmax: 528 multiplications in 22 to 26 us at 160 MHz (`specula latency`, DECISIONS.md 8).
constexpr double low_us_per_multiplication = 22.0 / 528.0;
constexpr double high_us_per_multiplication = 26.0 / 528.0;

/// What the steps take in multiplications: fw_log's polynomial, the cubic of Catmull and Rom, and a
/// square root's 14 cycles.
constexpr std::size_t logarithm = 10, cubic = 7, root = 14;

std::size_t of_features(const Descriptor& descriptor, std::size_t n_rows) {
    const std::size_t n = descriptor.bins.n_bins;
    std::size_t count = 0;
    if (descriptor.is_relative())  // cubics of both parts, a complex quotient
        return n_rows * (2 * cubic + 6) * n + logarithm + root;
    if (descriptor.normalise.align) count += cubic * n;
    if (descriptor.normalise.compensate_range) count += n;
    if (descriptor.normalise.logarithm) count += logarithm * n;
    if (descriptor.unit_energy) count += 2 * n + root;
    if (descriptor.angle_rx > 1)
        count += static_cast<std::size_t>(descriptor.angle_rx - 1) * (6 + root);
    if (descriptor.looks > 1) count += n;
    if (descriptor.spread) count += (2 + root) * n;
    return count;
}

}  // namespace

RungCost cost_of(const RungPlan& rung, const Model& model, int n_rows) {
    const FoldedModel folded = fold(model);
    RungCost cost{.n_features = model.n_features()};
    std::size_t n_numbers = 2 * model.n_features();  // mean and scale
    for (const AffineLayer<float>& layer : folded.layers) {
        cost.multiplications += layer.n_in * layer.n_out;
        n_numbers += layer.n_in * layer.n_out + layer.n_out;
    }
    cost.multiplications +=
        of_features(parse_descriptor(rung.descriptor), static_cast<std::size_t>(n_rows));
    if (rung.known_gain) cost.multiplications += model.n_features();
    cost.model_bytes = n_numbers * sizeof(float);
    const auto n = static_cast<double>(cost.multiplications);
    cost.low_us = n * low_us_per_multiplication;
    cost.high_us = n * high_us_per_multiplication;
    return cost;
}

}  // namespace specula
