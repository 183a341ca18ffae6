#include "sim/channel/coefficients.hpp"

#include <algorithm>
#include <cmath>

#include "materials/diffuse.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr int fewest_polynomials = 12;  ///< tried first

double thickness_m(const Stack& stack) {
    double sum = 0.0;
    for (const Layer& layer : stack.layers) sum += layer.thickness_m;
    return sum;
}

/// A sheet in air seen from its back: layers in reverse, each face's roughness moved with it.
Stack turned_over(const Stack& stack) {
    Stack turned = stack;
    std::reverse(turned.layers.begin(), turned.layers.end());
    const auto* below = std::get_if<HalfSpace>(&stack.backing);
    HalfSpace above = below ? HalfSpace{{}, below->roughness_m, below->correlation_m} : HalfSpace{};
    for (Layer& layer : turned.layers) {
        std::swap(above.roughness_m, layer.roughness_m);
        std::swap(above.correlation_m, layer.correlation_m);
    }
    turned.backing = above;
    return turned;
}

/// exp(jk c s): shortens a way by s along the normal.
Complex advance(const Stack& stack, double cos_incidence, double way_m) {
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    return std::polar(1.0, k * cos_incidence * way_m);
}

}  // namespace

TeTm reflection_of(const Stack& stack, double cos_incidence, bool from_behind) {
    const Reflection r = stack_reflection(from_behind ? turned_over(stack) : stack, cos_incidence);
    const Complex nearer =
        from_behind ? advance(stack, cos_incidence, 2.0 * thickness_m(stack)) : Complex(1.0);
    return {r.te * nearer, r.tm * nearer};
}

TeTm transmission_of(const Stack& stack, double cos_incidence) {
    const Transmission t = stack_transmission(stack, cos_incidence);
    const Complex instead_of_air = advance(stack, cos_incidence, thickness_m(stack));
    return {t.te * instead_of_air, t.tm * instead_of_air};
}

TeTm coefficients_of(const Event& event, const Stack& stack, double cos_incidence) {
    switch (event.kind) {
        case Event::Kind::reflect:
            return reflection_of(stack, cos_incidence, event.from_behind);
        case Event::Kind::transmit:
            return transmission_of(stack, cos_incidence);
        case Event::Kind::scatter:
            break;
    }
    const Reflection diffuse = diffuse_reflection(stack, face_of(stack, event.face), cos_incidence);
    return {diffuse.te, diffuse.tm};
}

AngularSeries angular_series(const Event& event, const Stack& stack, const ChebyshevGrid& cosines) {
    const auto n = static_cast<std::size_t>(cosines.n);
    const auto& to_series = coefficient_matrix(cosines.n);
    AngularSeries series{std::vector<Complex>(n), std::vector<Complex>(n)};
    for (std::size_t i = 0; i < n; ++i) {
        const TeTm c = coefficients_of(event, stack, cosines.node(static_cast<int>(i)));
        for (std::size_t k = 0; k < n; ++k) {
            series.te[k] += to_series[k * n + i] * c.te;
            series.tm[k] += to_series[k * n + i] * c.tm;
        }
    }
    return series;
}

int polynomials_needed(const Event& event, const Reflector& reflector,
                       std::span<const double> frequencies_hz, ChebyshevGrid cosines) {
    for (cosines.n = fewest_polynomials; cosines.n <= most_polynomials; cosines.n *= 2) {
        std::size_t needed = 1;
        for (const double frequency_hz : frequencies_hz) {
            const AngularSeries s = angular_series(event, reflector(frequency_hz), cosines);
            for (std::size_t k = needed; k < s.te.size(); ++k)
                if (std::abs(s.te[k]) + std::abs(s.tm[k]) > negligible_coefficient) needed = k + 1;
        }
        // A series cut too short folds its rest onto all of its terms, the last ones included.
        if (static_cast<int>(needed) <= cosines.n * 3 / 4) return static_cast<int>(needed);
    }
    return 0;
}

}  // namespace specula
