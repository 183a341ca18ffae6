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
    const double half_band_rad_m =
        0.5 * (wavenumber_rad_m(comb.last_hz()) - wavenumber_rad_m(comb.first_hz));
    const int n_needed = points_for_phase(half_band_rad_m * 0.5 * (path.high - path.low));
    const std::size_t n_nodes = Kernels::padded(2 * static_cast<std::size_t>(n_needed)) / 2;
    grid_ = {{comb.first_hz, comb.last_hz(), static_cast<int>(n_nodes)},
             {cosine.low, cosine.high, 0},
             0.5 * (path.low + path.high)};
    for (int i = 0; i < comb.n; ++i) comb_hz_.push_back(comb.at(i));
}

/// Moments interpolated from the nodes to the comb.
std::vector<double> StraightSums::on_comb(const Moments& moments) const {
    const auto n_q = static_cast<std::size_t>(grid_.frequency_hz.n);
    const auto n_p = static_cast<std::size_t>(grid_.cos_incidence.n);
    std::vector<double> at_nodes(n_q * n_columns_), at_comb(comb_hz_.size() * n_columns_);
    const auto put = [&](std::size_t row, const Complex* values) {
        for (std::size_t q = 0; q < n_q; ++q) {
            at_nodes[q * n_columns_ + 2 * row] = values[q].real();
            at_nodes[q * n_columns_ + 2 * row + 1] = values[q].imag();
        }
    };
    put(0, moments.incident.data());
    for (std::size_t p = 0; p < n_p; ++p) {
        put(1 + p, &moments.te[p * n_q]);
        put(1 + n_p + p, &moments.tm[p * n_q]);
    }
    kernels().add_products({n_q, comb_hz_.size(), n_columns_}, from_nodes_.data(), at_nodes.data(),
                           at_comb.data());
    return at_comb;
}

/// What leads from the nodes to the comb.
void StraightSums::make_carrier() {
    const std::size_t n = comb_hz_.size();
    std::vector<double> turns, cosine(n), sine(n);
    const double centre_rad_m = scatter_.rx.front().centre_rad_m;  // all RX have the same
    for (const double frequency_hz : comb_hz_)
        turns.push_back((centre_rad_m - wavenumber_rad_m(frequency_hz)) / two_pi *
                        grid_.reference_path_m);
    kernels().turn(turns.data(), n, cosine.data(), sine.data());
    for (std::size_t i = 0; i < n; ++i)
        carrier_.push_back(surface_factor * Complex(cosine[i], sine[i]));
    from_nodes_ = interpolation_matrix(grid_.frequency_hz, comb_hz_);
}

void StraightSums::sum_at_least(int n_polynomials) {
    if (grid_.cos_incidence.n >= n_polynomials) return;
    if (carrier_.empty()) make_carrier();
    grid_.cos_incidence.n = n_polynomials;
    n_columns_ = Kernels::padded(2 * (1 + 2 * static_cast<std::size_t>(n_polynomials)));
    moments_.clear();
    for (const PairScatter& pair : scatter_.rx)
        moments_.push_back(on_comb(moments_of(pair, grid_)));
}

StraightSums::Series StraightSums::series_of(const Reflector& reflector) const {
    const Event currents = currents_of(scatter_.route);
    if (const auto table =
            coefficient_table(currents, reflector, grid_.cos_incidence, grid_.frequency_hz))
        return {table->at(comb_hz_), table->cosine.n};
    // Coefficients that swing too fast over the band enter at every frequency by themselves.
    const std::array<double, 5> looks_hz{comb_.first_hz, comb_.at(comb_.n / 4),
                                         comb_.at(comb_.n / 2), comb_.at(3 * comb_.n / 4),
                                         comb_.last_hz()};
    ChebyshevGrid cosine = grid_.cos_incidence;
    cosine.n = polynomials_needed(currents, reflector, looks_hz, cosine);
    Series series{{}, cosine.n};
    if (cosine.n == 0) return series;
    for (const double frequency_hz : comb_hz_) {
        const AngularSeries here = angular_series(currents, reflector(frequency_hz), cosine);
        series.of.te.insert(series.of.te.end(), here.te.begin(), here.te.end());
        series.of.tm.insert(series.of.tm.end(), here.tm.begin(), here.tm.end());
    }
    return series;
}

bool StraightSums::add(const Reflector& reflector, Channel& channel) {
    if (is_empty_) return true;
    if (grid_.frequency_hz.n > most_over_comb * comb_.n) return false;
    const Series series = series_of(reflector);
    if (series.n_polynomials == 0) return false;
    sum_at_least(series.n_polynomials);
    const auto n_p = static_cast<std::size_t>(series.n_polynomials);
    const auto n_summed = static_cast<std::size_t>(grid_.cos_incidence.n);
    for (std::size_t rx = 0; rx < moments_.size(); ++rx) {
        Complex* h = channel.of_rx(static_cast<int>(rx));
        for (std::size_t i = 0; i < comb_hz_.size(); ++i) {
            const double* moment = &moments_[rx][i * n_columns_];
            const auto of_row = [&](std::size_t row) {
                return Complex(moment[2 * row], moment[2 * row + 1]);
            };
            Complex sum = of_row(0);
            for (std::size_t p = 0; p < n_p; ++p)
                sum += series.of.te[i * n_p + p] * of_row(1 + p) +
                       series.of.tm[i * n_p + p] * of_row(1 + n_summed + p);
            h[i] += carrier_[i] * sum;
        }
    }
    return true;
}

}  // namespace specula
