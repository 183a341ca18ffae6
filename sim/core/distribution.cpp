#include "sim/core/distribution.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

template <typename... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <typename... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

/// z of the standard normal law with Phi(z) = u, for u <= 1/2, to rounding.
///
/// Newton's method on log Phi, which is concave and rises: from the left of the root, where
/// Phi(-t) <= exp(-t^2/2) / 2 puts the first step, it never passes the root.
double lower_normal_quantile(double u) {
    double z = -std::sqrt(-2.0 * std::log(u));
    for (int step = 0; step < 60; ++step) {
        const double below = 0.5 * std::erfc(-z / std::sqrt(2.0));
        const double density = std::exp(-0.5 * z * z) * 0.3989422804014327;  // 1 / sqrt(2 pi)
        const double change = std::log(u / below) * below / density;
        z += change;
        if (std::abs(change) < 1e-15 * (1.0 + std::abs(z))) break;
    }
    return z;
}

double normal_quantile(double u) {
    return u <= 0.5 ? lower_normal_quantile(u) : -lower_normal_quantile(1.0 - u);
}

double chosen(const Distribution::Choice& law, double u) {
    const auto n = law.values.size();
    return law.values[std::min(n - 1, static_cast<std::size_t>(u * static_cast<double>(n)))];
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

double Distribution::sample(Stream& stream) const {
    const double u = stream.uniform();
    const double z = stream.normal();
    return std::visit(
        Overloaded{
            [](const Fixed& law) { return law.value; },
            [&](const Uniform& law) { return law.low + u * (law.high - law.low); },
            [&](const Normal& law) { return law.mean + z * law.sd; },
            [&](const Factor& law) { return law.median * std::exp(z * std::log(law.ratio)); },
            [&](const Choice& law) { return chosen(law, u); },
        },
        law_);
}

double Distribution::quantile(double u) const {
    SPECULA_EXPECT(u > 0.0 && u < 1.0);
    return std::visit(Overloaded{
                          [](const Fixed& law) { return law.value; },
                          [&](const Uniform& law) { return law.low + u * (law.high - law.low); },
                          [&](const Normal& law) { return law.mean + normal_quantile(u) * law.sd; },
                          [&](const Factor& law) {
                              return law.median *
                                     std::exp(normal_quantile(u) * std::log(law.ratio));
                          },
                          [&](const Choice& law) { return chosen(law, u); },
                      },
                      law_);
}

double Distribution::median() const {
    return std::visit(Overloaded{
                          [](const Fixed& law) { return law.value; },
                          [](const Uniform& law) { return 0.5 * (law.low + law.high); },
                          [](const Normal& law) { return law.mean; },
                          [](const Factor& law) { return law.median; },
                          [](const Choice& law) {
                              std::vector<double> sorted = law.values;
                              std::sort(sorted.begin(), sorted.end());
                              return sorted[(sorted.size() - 1) / 2];
                          },
                      },
                      law_);
}

double Distribution::spread() const {
    return std::visit(Overloaded{
                          [](const Fixed&) { return 0.0; },
                          [](const Uniform& law) { return (law.high - law.low) / std::sqrt(12.0); },
                          [](const Normal& law) { return law.sd; },
                          [](const Factor& law) { return std::log(law.ratio); },
                          [](const Choice& law) { return deviation_of(law.values); },
                      },
                      law_);
}

}  // namespace specula
