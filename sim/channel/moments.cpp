#include "sim/channel/moments.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

Moments moments_of(const PairScatter& pair, const MomentGrid& grid) {
    const auto n_f = static_cast<std::size_t>(grid.frequency_hz.n);
    const auto n_p = static_cast<std::size_t>(grid.cos_incidence.n);
    std::vector<double> wavenumber(n_f);
    for (std::size_t q = 0; q < n_f; ++q)
        wavenumber[q] = two_pi * grid.frequency_hz.node(static_cast<int>(q)) / speed_of_light_m_s;

    // Real and imaginary parts apart, so that the inner loops are plain arrays.
    std::vector<double> re(n_f), im(n_f), polynomial(n_p);
    std::vector<double> incident(2 * n_f, 0.0), te(2 * n_p * n_f, 0.0), tm(2 * n_p * n_f, 0.0);
    for (std::size_t i = 0; i < pair.path_m.size(); ++i) {
        const double path_m = pair.path_m[i] - grid.reference_path_m;
        for (std::size_t q = 0; q < n_f; ++q) {
            const double phase_rad = pair.phase_at(i) - wavenumber[q] * path_m;
            re[q] = std::cos(phase_rad);
            im[q] = std::sin(phase_rad);
        }
        chebyshev_polynomials(grid.cos_incidence.unit(pair.cos_incidence[i]), polynomial);
        const auto accumulate = [&](double weight, double* sums) {
            for (std::size_t q = 0; q < n_f; ++q) {
                sums[q] += weight * re[q];
                sums[n_f + q] += weight * im[q];
            }
        };
        accumulate(pair.weight[0][i], incident.data());
        for (std::size_t p = 0; p < n_p; ++p) {
            accumulate(pair.weight[1][i] * polynomial[p], &te[2 * p * n_f]);
            accumulate(pair.weight[2][i] * polynomial[p], &tm[2 * p * n_f]);
        }
    }

    const auto joined = [n_f](const std::vector<double>& sums, std::size_t n_rows) {
        std::vector<std::complex<double>> values(n_rows * n_f);
        for (std::size_t p = 0; p < n_rows; ++p)
            for (std::size_t q = 0; q < n_f; ++q)
                values[p * n_f + q] = {sums[2 * p * n_f + q], sums[(2 * p + 1) * n_f + q]};
        return values;
    };
    return {joined(incident, 1), joined(te, n_p), joined(tm, n_p)};
}

}  // namespace specula
