#include "sim/channel/straight_sums.hpp"

#include <algorithm>
#include <array>

#include "sim/core/constants.hpp"
#include "sim/core/kernels.hpp"

namespace specula {

namespace {

constexpr Complex surface_factor{0.0, -1.0 / (8.0 * pi)};

double wavenumber_rad_m(double frequency_hz) {
    return two_pi * frequency_hz / speed_of_light_m_s;
}

/// Few frequencies are worth while only if they are not many more than those of the comb.
constexpr int most_over_comb = 4;

}  // namespace

Event currents_of(const Route& route) {
    const bool mirror = route.rough_face == Route::mirror;
    return {.kind = mirror ? Event::Kind::reflect : Event::Kind::scatter,
            .body = route.body,
            .from_behind = route.from_behind,
            .face = mirror ? 0 : route.rough_face};
}

StraightSums::StraightSums(const RouteScatter& scatter, const FrequencyComb& comb)
    : scatter_(scatter), comb_(comb) {
    const Scatter::Extent path = path_extent_m(scatter), cosine = cosine_extent(scatter);
    is_empty_ = path.high == 0.0;
    reference_path_m_ = 0.5 * (path.low + path.high);
    const double half_band_rad_m =
        0.5 * (wavenumber_rad_m(comb.last_hz()) - wavenumber_rad_m(comb.first_hz));
    n_for_paths_ = points_for_phase(half_band_rad_m * 0.5 * (path.high - path.low));
    grid_ = {{comb.first_hz, comb.last_hz(), 0}, {cosine.low, cosine.high, 0}, reference_path_m_};
}

void StraightSums::sum_at_least(int n_frequencies, int n_polynomials) {
    if (grid_.frequency_hz.n >= n_frequencies && grid_.cos_incidence.n >= n_polynomials) return;
    if (grid_.frequency_hz.n < n_frequencies)
        grid_.frequency_hz.n =
            static_cast<int>(Kernels::padded(static_cast<std::size_t>(n_frequencies)));
    grid_.cos_incidence.n = std::max(grid_.cos_incidence.n, n_polynomials);
    nodes_hz_.clear();
    for (int q = 0; q < grid_.frequency_hz.n; ++q) nodes_hz_.push_back(grid_.frequency_hz.node(q));
    moments_.clear();
    for (const PairScatter& pair : scatter_.rx) moments_.push_back(moments_of(pair, grid_));

    std::vector<double> frequencies_hz, turns;
    for (int i = 0; i < comb_.n; ++i) {
        frequencies_hz.push_back(comb_.at(i));
        turns.push_back(-comb_.at(i) / speed_of_light_m_s * reference_path_m_);
    }
    const auto n = frequencies_hz.size(), n_f = nodes_hz_.size();
    const std::vector<double> by_frequency =
        interpolation_matrix(grid_.frequency_hz, frequencies_hz);
    from_nodes_.resize(n * n_f);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t q = 0; q < n_f; ++q) from_nodes_[q * n + i] = by_frequency[i * n_f + q];
    std::vector<double> cosine(n), sine(n);
    kernels().turn(turns.data(), n, cosine.data(), sine.data());
    carrier_.clear();
    for (std::size_t i = 0; i < n; ++i)
        carrier_.push_back(surface_factor * Complex(cosine[i], sine[i]));
}

/// @in  at_nodes  (node, rx)
void StraightSums::add_interpolated(const std::vector<Complex>& at_nodes, Channel& channel) const {
    const auto n = static_cast<std::size_t>(comb_.n), n_f = nodes_hz_.size();
    const auto n_rx = static_cast<std::size_t>(channel.n_rx);
    const std::size_t n_columns = Kernels::padded(2 * n_rx);
    std::vector<double> columns(n_f * n_columns), sums(n * n_columns);
    for (std::size_t q = 0; q < n_f; ++q)
        for (std::size_t rx = 0; rx < n_rx; ++rx) {
            columns[q * n_columns + 2 * rx] = at_nodes[q * n_rx + rx].real();
            columns[q * n_columns + 2 * rx + 1] = at_nodes[q * n_rx + rx].imag();
        }
    kernels().add_products({n_f, n, n_columns}, from_nodes_.data(), columns.data(), sums.data());
    for (std::size_t rx = 0; rx < n_rx; ++rx) {
        Complex* h = channel.of_rx(static_cast<int>(rx));
        for (std::size_t i = 0; i < n; ++i)
            h[i] += carrier_[i] *
                    Complex(sums[i * n_columns + 2 * rx], sums[i * n_columns + 2 * rx + 1]);
    }
}

bool StraightSums::add_smooth(const CoefficientTable& table, Channel& channel) {
    // The product of two series of degrees m and n has the degree m + n.
    sum_at_least(n_for_paths_ + table.frequency_hz.n - 1, table.cosine.n);
    const AngularSeries series = table.at(nodes_hz_);
    const auto n_f = nodes_hz_.size(), n_rx = moments_.size();
    const auto n_p = static_cast<std::size_t>(table.cosine.n);
    std::vector<Complex> at_nodes(n_f * n_rx);
    for (std::size_t rx = 0; rx < n_rx; ++rx)
        for (std::size_t q = 0; q < n_f; ++q) {
            Complex sum = moments_[rx].incident[q];
            for (std::size_t p = 0; p < n_p; ++p)
                sum += series.te[p * n_f + q] * moments_[rx].te[p * n_f + q] +
                       series.tm[p * n_f + q] * moments_[rx].tm[p * n_f + q];
            at_nodes[q * n_rx + rx] = sum;
        }
    add_interpolated(at_nodes, channel);
    return true;
}

/// A material whose coefficients swing too fast over the band: they enter at every frequency.
bool StraightSums::add_swinging(const Reflector& reflector, Channel& channel) {
    const Event currents = currents_of(scatter_.route);
    const std::array<double, 5> looks_hz{comb_.first_hz, comb_.at(comb_.n / 4),
                                         comb_.at(comb_.n / 2), comb_.at(3 * comb_.n / 4),
                                         comb_.last_hz()};
    ChebyshevGrid cosine = grid_.cos_incidence;
    cosine.n = polynomials_needed(currents, reflector, looks_hz, cosine);
    if (cosine.n == 0) return false;
    sum_at_least(n_for_paths_, cosine.n);
    const auto n = static_cast<std::size_t>(comb_.n), n_f = nodes_hz_.size();
    const auto n_p = static_cast<std::size_t>(cosine.n);
    for (std::size_t i = 0; i < n; ++i) {
        const AngularSeries series =
            angular_series(currents, reflector(comb_.at(static_cast<int>(i))), cosine);
        for (std::size_t rx = 0; rx < moments_.size(); ++rx) {
            const Moments& moments = moments_[rx];
            Complex sum = 0.0;
            for (std::size_t q = 0; q < n_f; ++q) {
                Complex at_node = moments.incident[q];
                for (std::size_t p = 0; p < n_p; ++p)
                    at_node += series.te[p] * moments.te[p * n_f + q] +
                               series.tm[p] * moments.tm[p * n_f + q];
                sum += from_nodes_[q * n + i] * at_node;
            }
            channel.of_rx(static_cast<int>(rx))[i] += carrier_[i] * sum;
        }
    }
    return true;
}

bool StraightSums::add(const Reflector& reflector, Channel& channel) {
    if (is_empty_) return true;
    if (n_for_paths_ > most_over_comb * comb_.n) return false;
    const auto table = coefficient_table(currents_of(scatter_.route), reflector,
                                         grid_.cos_incidence, grid_.frequency_hz);
    return table ? add_smooth(*table, channel) : add_swinging(reflector, channel);
}

}  // namespace specula
