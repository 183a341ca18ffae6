#include "sim/channel/edge_channel.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// Metals send back more than this, thinly coated or not; the best dielectric, a quarter wave of
/// alumina, 0.81.
constexpr double metallic = 0.95;
/// How far the reflection may be turned against a perfect conductor's: 0.1 mm of rust, 0.2.
constexpr double nearly_perfect = 0.25;

}  // namespace

Complex edge_coefficient(const Stack& stack) {
    const Complex reflection = stack_reflection(stack, 1.0).te;
    const bool conducts =
        std::abs(reflection) > metallic && std::abs(reflection + 1.0) < nearly_perfect;
    return conducts ? -reflection : Complex(0.0);
}

Complex edge_sum(const Scatter& scatter, int rx, std::span<const Reflector> reflectors,
                 double frequency_hz) {
    const double k = two_pi * frequency_hz / speed_of_light_m_s;
    Complex sum = 0.0;
    for (const EdgeScatter& edges : scatter.edges) {
        const PairScatter& pair = edges.rx[static_cast<std::size_t>(rx)];
        if (pair.path_m.empty()) continue;
        const Complex coefficient =
            edge_coefficient(reflectors[static_cast<std::size_t>(edges.body)](frequency_hz));
        if (coefficient == 0.0) continue;
        Complex of_body = 0.0;
        for (std::size_t i = 0; i < pair.path_m.size(); ++i)
            of_body += pair.weight[0][i] * std::polar(1.0, -k * pair.path_m[i]);
        sum += coefficient * of_body;
    }
    return -sum / (8.0 * pi * k);  // -j/(8 pi) over jk
}

void add_edges(const Scatter& scatter, std::span<const Reflector> reflectors,
               const FrequencyComb& comb, Channel& channel) {
    if (scatter.edges.empty()) return;
    for (int rx = 0; rx < channel.n_rx; ++rx)
        for (int i = 0; i < comb.n; ++i)
            channel.of_rx(rx)[i] += edge_sum(scatter, rx, reflectors, comb.at(i));
}

}  // namespace specula
