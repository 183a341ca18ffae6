#include "sim/channel/channel.hpp"

#include <cmath>

#include "sim/channel/moments.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr Complex surface_factor{0.0, -1.0 / (8.0 * pi)};
constexpr int fewest_polynomials = 12;  ///< tried first
constexpr int most_polynomials = 192;   ///< beyond, plain sums are hardly slower
constexpr double angular_tolerance = 1e-8;

double wavenumber_rad_m(double frequency_hz) {
    return two_pi * frequency_hz / speed_of_light_m_s;
}

/// Chebyshev coefficients in cos(incidence) of a reflector at one frequency.
struct AngularSeries {
    std::vector<Complex> te, tm;  ///< (polynomial)
};

AngularSeries angular_series(const Reflector& reflector, double frequency_hz,
                             const ChebyshevGrid& cosines, const std::vector<double>& to_series) {
    const Stack stack = reflector(frequency_hz);
    const auto n = static_cast<std::size_t>(cosines.n);
    AngularSeries series{std::vector<Complex>(n), std::vector<Complex>(n)};
    for (std::size_t i = 0; i < n; ++i) {
        const Reflection r = stack_reflection(stack, cosines.node(static_cast<int>(i)));
        for (std::size_t k = 0; k < n; ++k) {
            series.te[k] += to_series[k * n + i] * r.te;
            series.tm[k] += to_series[k * n + i] * r.tm;
        }
    }
    return series;
}

/// How many polynomials carry the angle dependence of this reflector over these angles, up to
/// `most_polynomials`; 0 when that is not enough. A thick sheet of low loss needs many.
int polynomials_needed(const Reflector& reflector, const FrequencyComb& comb,
                       ChebyshevGrid cosines) {
    for (cosines.n = fewest_polynomials; cosines.n <= most_polynomials; cosines.n *= 2) {
        const auto to_series = coefficient_matrix(cosines.n);
        int needed = 1;
        for (const int i : {0, comb.n / 4, comb.n / 2, 3 * comb.n / 4, comb.n - 1}) {
            const AngularSeries s = angular_series(reflector, comb.at(i), cosines, to_series);
            for (int k = needed; k < cosines.n; ++k)
                if (std::abs(s.te[static_cast<std::size_t>(k)]) +
                        std::abs(s.tm[static_cast<std::size_t>(k)]) >
                    angular_tolerance)
                    needed = k + 1;
        }
        // A series cut too short folds its rest onto all of its terms, the last ones included.
        if (needed <= cosines.n * 3 / 4) return needed;
    }
    return 0;
}

/// The plain sums, for what no short series in the cosine describes.
void sum_plainly(const Scatter& scatter, const Reflector& reflector, const FrequencyComb& comb,
                 Channel& channel) {
    for (int rx = 0; rx < channel.n_rx; ++rx)
        for (int i = 0; i < comb.n; ++i)
            channel.of_rx(rx)[i] =
                direct_sum(scatter.rx[static_cast<std::size_t>(rx)], reflector, comb.at(i));
}

}  // namespace

Channel channel_of(const Scatter& scatter, const Reflector& reflector, const FrequencyComb& comb) {
    const auto n_comb = static_cast<std::size_t>(comb.n);
    Channel channel{.n_rx = static_cast<int>(scatter.rx.size()),
                    .n_frequencies = comb.n,
                    .h = std::vector<Complex>(scatter.rx.size() * n_comb)};
    const Scatter::Extent path = scatter.path_m();
    if (path.high == 0.0) return channel;
    channel.reference_path_m = 0.5 * (path.low + path.high);

    const Scatter::Extent cosine = scatter.cos_incidence();
    const double half_band_rad_m =
        0.5 * (wavenumber_rad_m(comb.last_hz()) - wavenumber_rad_m(comb.first_hz));
    MomentGrid grid{.frequency_hz = {comb.first_hz, comb.last_hz(), 1},
                    .cos_incidence = {cosine.low, cosine.high, 1},
                    .reference_path_m = channel.reference_path_m};
    grid.frequency_hz.n = points_for_phase(half_band_rad_m * 0.5 * (path.high - path.low));
    grid.cos_incidence.n = polynomials_needed(reflector, comb, grid.cos_incidence);
    if (grid.cos_incidence.n == 0) {
        sum_plainly(scatter, reflector, comb, channel);
        return channel;
    }

    std::vector<double> frequencies_hz(n_comb);
    for (std::size_t i = 0; i < n_comb; ++i) frequencies_hz[i] = comb.at(static_cast<int>(i));
    const auto from_nodes = interpolation_matrix(grid.frequency_hz, frequencies_hz);
    const auto to_series = coefficient_matrix(grid.cos_incidence.n);
    const auto n_f = static_cast<std::size_t>(grid.frequency_hz.n);
    const auto n_p = static_cast<std::size_t>(grid.cos_incidence.n);

    std::vector<AngularSeries> series;
    for (const double f_hz : frequencies_hz)
        series.push_back(angular_series(reflector, f_hz, grid.cos_incidence, to_series));
    for (int rx = 0; rx < channel.n_rx; ++rx) {
        const Moments moments = moments_of(scatter.rx[static_cast<std::size_t>(rx)], grid);
        for (std::size_t i = 0; i < n_comb; ++i) {
            Complex sum = 0.0;
            for (std::size_t q = 0; q < n_f; ++q) {
                Complex at_node = moments.incident[q];
                for (std::size_t p = 0; p < n_p; ++p)
                    at_node += series[i].te[p] * moments.te[p * n_f + q] +
                               series[i].tm[p] * moments.tm[p * n_f + q];
                sum += from_nodes[i * n_f + q] * at_node;
            }
            const double turn_rad = wavenumber_rad_m(frequencies_hz[i]) * channel.reference_path_m;
            channel.of_rx(rx)[i] = surface_factor * std::polar(1.0, -turn_rad) * sum;
        }
    }
    return channel;
}

Complex direct_sum(const PairScatter& pair, const Reflector& reflector, double frequency_hz) {
    const Stack stack = reflector(frequency_hz);
    const double k = wavenumber_rad_m(frequency_hz);
    Complex sum = 0.0;
    for (std::size_t i = 0; i < pair.path_m.size(); ++i) {
        const Reflection r = stack_reflection(stack, pair.cos_incidence[i]);
        sum += std::polar(1.0, -k * pair.path_m[i]) *
               (pair.incident[i] + r.te * pair.te[i] + r.tm * pair.tm[i]);
    }
    return surface_factor * sum;
}

}  // namespace specula
