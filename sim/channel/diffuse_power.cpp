#include "sim/channel/diffuse_power.hpp"

#include <array>

#include "sim/channel/coefficients.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr double surface_factor_squared = 1.0 / (64.0 * pi * pi);

/// A route's coefficients at one frequency, by series where one is short enough.
class Spectrum {
  public:
    Spectrum(const Event& event, const Stack& stack, const ChebyshevGrid& cosines)
        : event_(event), stack_(stack), cosines_(cosines) {
        if (cosines.n > 0) series_ = angular_series(event, stack, cosines);
    }

    TeTm operator()(double cosine) const {
        if (cosines_.n == 0) return coefficients_of(event_, stack_, cosine);
        std::array<double, most_polynomials> polynomials{};
        const auto n = static_cast<std::size_t>(cosines_.n);
        chebyshev_polynomials(cosines_.unit(cosine), std::span(polynomials).first(n));
        TeTm value{};
        for (std::size_t k = 0; k < n; ++k) {
            value.te += series_.te[k] * polynomials[k];
            value.tm += series_.tm[k] * polynomials[k];
        }
        return value;
    }

  private:
    Event event_;
    Stack stack_;
    ChebyshevGrid cosines_;
    AngularSeries series_;
};

}  // namespace

std::vector<double> mean_diffuse_power(const RouteScatter& cells,
                                       std::span<const Reflector> reflectors,
                                       const FrequencyComb& comb) {
    const Event event{.kind = Event::Kind::scatter,
                      .body = cells.route.body,
                      .from_behind = false,
                      .face = cells.route.rough_face};
    const Reflector& reflector = reflectors[static_cast<std::size_t>(cells.route.body)];
    const Scatter::Extent extent = cosine_extent(cells);
    ChebyshevGrid cosines{extent.low, extent.high, 1};
    const std::array<double, 3> looks_hz{comb.first_hz, comb.at(comb.n / 2), comb.last_hz()};
    cosines.n = polynomials_needed(event, reflector, looks_hz, cosines);

    std::vector<double> power(cells.rx.size() * static_cast<std::size_t>(comb.n), 0.0);
    for (int i = 0; i < comb.n; ++i) {
        const Spectrum spectrum(event, reflector(comb.at(i)), cosines);
        for (std::size_t rx = 0; rx < cells.rx.size(); ++rx) {
            const PairScatter& pair = cells.rx[rx];
            double sum = 0.0;
            for (std::size_t point = 0; point < pair.path_m.size(); ++point) {
                const TeTm c = spectrum(pair.cos_incidence[point]);
                sum += std::norm(pair.weight[1][point] * c.te + pair.weight[2][point] * c.tm);
            }
            power[rx * static_cast<std::size_t>(comb.n) + static_cast<std::size_t>(i)] =
                surface_factor_squared * sum;
        }
    }
    return power;
}

}  // namespace specula
