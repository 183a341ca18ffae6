#include "sim/channel/coefficient_table.hpp"

#include <algorithm>
#include <cmath>

namespace specula {

namespace {

constexpr int tried_first = 6;
/// A double series leaves out many more terms than one over the cosine alone.
constexpr double negligible_term = 0.1 * negligible_coefficient;
constexpr int most_over_frequency = most_polynomials / 3;

/// All coefficients at n_p cosines and n_k frequencies, as a double series.
CoefficientTable sampled(const Event& event, const Reflector& reflector,
                         const ChebyshevGrid& cosine, const ChebyshevGrid& frequency_hz) {
    const auto n_p = static_cast<std::size_t>(cosine.n);
    const auto n_k = static_cast<std::size_t>(frequency_hz.n);
    CoefficientTable table{cosine, frequency_hz, std::vector<Complex>(n_p * n_k),
                           std::vector<Complex>(n_p * n_k)};
    const std::vector<double> over_cosine = coefficient_matrix(cosine.n);
    const std::vector<double> over_frequency = coefficient_matrix(frequency_hz.n);
    std::vector<Complex> te(n_p), tm(n_p);
    for (std::size_t node = 0; node < n_k; ++node) {
        const Stack stack = reflector(frequency_hz.node(static_cast<int>(node)));
        std::fill(te.begin(), te.end(), Complex{});
        std::fill(tm.begin(), tm.end(), Complex{});
        for (std::size_t i = 0; i < n_p; ++i) {
            const TeTm c = coefficients_of(event, stack, cosine.node(static_cast<int>(i)));
            for (std::size_t p = 0; p < n_p; ++p) {
                te[p] += over_cosine[p * n_p + i] * c.te;
                tm[p] += over_cosine[p * n_p + i] * c.tm;
            }
        }
        for (std::size_t p = 0; p < n_p; ++p)
            for (std::size_t k = 0; k < n_k; ++k) {
                table.te[p * n_k + k] += over_frequency[k * n_k + node] * te[p];
                table.tm[p * n_k + k] += over_frequency[k * n_k + node] * tm[p];
            }
    }
    return table;
}

/// How many polynomials of each kind carry all that is above `negligible_term`.
struct Needed {
    int cosine = 1;
    int frequency = 1;
};

Needed needed_of(const CoefficientTable& table) {
    Needed needed;
    const auto n_k = static_cast<std::size_t>(table.frequency_hz.n);
    for (std::size_t i = 0; i < table.te.size(); ++i) {
        if (std::abs(table.te[i]) + std::abs(table.tm[i]) <= negligible_term) continue;
        needed.cosine = std::max(needed.cosine, static_cast<int>(i / n_k) + 1);
        needed.frequency = std::max(needed.frequency, static_cast<int>(i % n_k) + 1);
    }
    return needed;
}

CoefficientTable cut(const CoefficientTable& table, const Needed& needed) {
    CoefficientTable kept{table.cosine, table.frequency_hz, {}, {}};
    kept.cosine.n = needed.cosine;
    kept.frequency_hz.n = needed.frequency;
    for (int p = 0; p < needed.cosine; ++p)
        for (int k = 0; k < needed.frequency; ++k) {
            const auto i = static_cast<std::size_t>(p * table.frequency_hz.n + k);
            kept.te.push_back(table.te[i]);
            kept.tm.push_back(table.tm[i]);
        }
    return kept;
}

}  // namespace

AngularSeries CoefficientTable::at(std::span<const double> frequencies_hz) const {
    const auto n_p = static_cast<std::size_t>(cosine.n);
    const auto n_k = static_cast<std::size_t>(frequency_hz.n);
    const std::size_t n = frequencies_hz.size();
    AngularSeries series{std::vector<Complex>(n_p * n), std::vector<Complex>(n_p * n)};
    std::vector<double> polynomials(n_k);
    for (std::size_t i = 0; i < n; ++i) {
        chebyshev_polynomials(frequency_hz.unit(frequencies_hz[i]), polynomials);
        for (std::size_t p = 0; p < n_p; ++p)
            for (std::size_t k = 0; k < n_k; ++k) {
                series.te[p * n + i] += te[p * n_k + k] * polynomials[k];
                series.tm[p * n + i] += tm[p * n_k + k] * polynomials[k];
            }
    }
    return series;
}

std::optional<CoefficientTable> coefficient_table(const Event& event, const Reflector& reflector,
                                                  ChebyshevGrid cosine,
                                                  ChebyshevGrid frequency_hz) {
    cosine.n = frequency_hz.n = tried_first;
    // Once the end of a series shows, how many it takes is known.
    const auto next_of = [](int needed, int n) { return needed < n ? needed * 4 / 3 + 2 : 2 * n; };
    // Where a series is cut too short, its rest folds onto all its terms, the last ones included.
    const auto is_enough = [](int needed, int n) { return needed <= n * 3 / 4; };
    while (cosine.n <= most_polynomials && frequency_hz.n <= most_over_frequency) {
        const CoefficientTable table = sampled(event, reflector, cosine, frequency_hz);
        const Needed needed = needed_of(table);
        const bool enough =
            is_enough(needed.cosine, cosine.n) && is_enough(needed.frequency, frequency_hz.n);
        if (enough) return cut(table, needed);
        if (!is_enough(needed.cosine, cosine.n)) cosine.n = next_of(needed.cosine, cosine.n);
        if (!is_enough(needed.frequency, frequency_hz.n))
            frequency_hz.n = next_of(needed.frequency, frequency_hz.n);
    }
    return std::nullopt;
}

}  // namespace specula
