#include "sim/channel/coefficient_table.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/kernels.hpp"

namespace specula {

namespace {

constexpr int tried_first = 6;
/// Terms at the end of a series that must at least be negligible, to tell that it is the end.
constexpr int least_spare = 2;
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
    const std::vector<double>& over_cosine = coefficient_matrix(cosine.n);
    const std::vector<double>& over_frequency = coefficient_matrix(frequency_hz.n);
    const std::vector<double> cosines = cosine.nodes();
    std::vector<Complex> te(n_p), tm(n_p);
    for (std::size_t node = 0; node < n_k; ++node) {
        const Stack stack = reflector(frequency_hz.node(static_cast<int>(node)));
        std::fill(te.begin(), te.end(), Complex{});
        std::fill(tm.begin(), tm.end(), Complex{});
        for (std::size_t i = 0; i < n_p; ++i) {
            const TeTm c = coefficients_of(event, stack, cosines[i]);
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

/// Whether |te| + |tm| is at most `negligible_term`; as a rule the squares tell.
bool is_negligible(const Complex& te, const Complex& tm) {
    constexpr double limit = negligible_term * negligible_term;
    const double squares = std::norm(te) + std::norm(tm);
    if (squares > limit) return false;
    if (2.0 * squares <= limit) return true;
    return std::abs(te) + std::abs(tm) <= negligible_term;
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
        if (is_negligible(table.te[i], table.tm[i])) continue;
        needed.cosine = std::max(needed.cosine, static_cast<int>(i / n_k) + 1);
        needed.frequency = std::max(needed.frequency, static_cast<int>(i % n_k) + 1);
    }
    return needed;
}

/// Where a series is cut too short, its rest folds onto all its terms, the last ones included.
int with_spare(int needed) {
    return needed + needed / 8 + least_spare;
}

/// Terms of a series of which `needed` tells how many of n are not negligible; more than `most`
/// where no n up to it shows the end.
template <typename Count>
int length_of(const Count& needed, int most) {
    for (int n = tried_first; n <= most;) {
        const int length = needed(n);
        if (with_spare(length) <= n) return length;
        n = length < n ? with_spare(with_spare(length)) : 2 * n;
    }
    return most + 1;
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
    const std::size_t n = frequencies_hz.size(), n_columns = Kernels::padded(4 * n_p);
    std::vector<double> polynomials(n_k), over_k(n_k * n), columns(n_k * n_columns),
        sums(n * n_columns);
    for (std::size_t i = 0; i < n; ++i) {
        chebyshev_polynomials(frequency_hz.unit(frequencies_hz[i]), polynomials);
        for (std::size_t k = 0; k < n_k; ++k) over_k[k * n + i] = polynomials[k];
    }
    for (std::size_t k = 0; k < n_k; ++k)
        for (std::size_t p = 0; p < n_p; ++p) {
            double* parts = &columns[k * n_columns + 4 * p];
            parts[0] = te[p * n_k + k].real();
            parts[1] = te[p * n_k + k].imag();
            parts[2] = tm[p * n_k + k].real();
            parts[3] = tm[p * n_k + k].imag();
        }
    kernels().add_products({n_k, n, n_columns}, over_k.data(), columns.data(), sums.data());
    AngularSeries series;
    series.te.reserve(n * n_p);
    series.tm.reserve(n * n_p);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t p = 0; p < n_p; ++p) {
            const double* parts = &sums[i * n_columns + 4 * p];
            series.te.emplace_back(parts[0], parts[1]);
            series.tm.emplace_back(parts[2], parts[3]);
        }
    return series;
}

std::optional<CoefficientTable> coefficient_table(const Event& event, const Reflector& reflector,
                                                  ChebyshevGrid cosine,
                                                  ChebyshevGrid frequency_hz) {
    const auto table_of = [&](const ChebyshevGrid& c, const ChebyshevGrid& f) {
        return sampled(event, reflector, c, f);
    };
    // How long both series are shows along the edges, at a small part of the cost of the area: a
    // way in a layer turns over the cosine fastest at the highest frequency, and over the frequency
    // at the steepest incidence.
    const ChebyshevGrid steepest{cosine.high, cosine.high, 1};
    const ChebyshevGrid highest{frequency_hz.high, frequency_hz.high, 1};
    const auto along_cosine = [&](int n) {
        return needed_of(table_of({cosine.low, cosine.high, n}, highest)).cosine;
    };
    const auto along_frequency = [&](int n) {
        return needed_of(table_of(steepest, {frequency_hz.low, frequency_hz.high, n})).frequency;
    };
    cosine.n = with_spare(length_of(along_cosine, most_polynomials));
    frequency_hz.n = with_spare(length_of(along_frequency, most_over_frequency));
    while (cosine.n <= most_polynomials && frequency_hz.n <= most_over_frequency) {
        const CoefficientTable table = table_of(cosine, frequency_hz);
        const Needed needed = needed_of(table);
        const bool long_enough = needed.cosine + least_spare <= cosine.n &&
                                 needed.frequency + least_spare <= frequency_hz.n;
        if (long_enough) return cut(table, needed);
        cosine.n = std::max(cosine.n, with_spare(needed.cosine));
        frequency_hz.n = std::max(frequency_hz.n, with_spare(needed.frequency));
    }
    return std::nullopt;
}

}  // namespace specula
