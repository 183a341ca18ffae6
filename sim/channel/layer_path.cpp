#include "sim/channel/layer_path.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr double left = 1e-4;
/// Beyond this many turns nothing is smooth, and every point has to be asked.
constexpr double most_turns = 1000.0;

/// Reflection of each face at normal incidence, the uppermost first.
std::vector<double> faces_of(const Stack& stack) {
    std::vector<double> faces;
    Electrics above;
    for (const Layer& layer : stack.layers) {
        faces.push_back(std::abs(fresnel(above, layer.medium, 0.0).te));
        above = layer.medium;
    }
    const auto* half_space = std::get_if<HalfSpace>(&stack.backing);
    faces.push_back(half_space ? std::abs(fresnel(above, half_space->medium, 0.0).te) : 1.0);
    return faces;
}

/// What absorption leaves of a wave that goes down and up again.
double twice_through(const Layer& layer, double wavenumber_rad_m) {
    return std::exp(2.0 * wavenumber_rad_m * layer.thickness_m *
                    longitudinal_wavenumber(layer.medium, 0.0).imag());
}

double path_without_grain(const Stack& stack) {
    const std::vector<double> faces = faces_of(stack);
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    double longest_m = 0.0, entered = 1.0;
    // Waves turn between any two faces that they come down to.
    for (std::size_t first = 0; first < stack.layers.size() && entered >= left; ++first) {
        double path_m = 0.0, kept = 1.0;
        for (std::size_t last = first; last < stack.layers.size(); ++last) {
            const Layer& layer = stack.layers[last];
            const Complex q = longitudinal_wavenumber(layer.medium, 0.0);
            path_m += 2.0 * layer.thickness_m / std::abs(q);
            kept *= twice_through(layer, k);
            const double per_turn = faces[first] * faces[last + 1] * kept;
            // The first pass lacks the upper face's reflection: what enters comes out at once.
            if (kept * faces[last + 1] < left) continue;
            const double turns =
                per_turn < 1.0 ? std::ceil(std::log(left) / std::log(per_turn)) : most_turns;
            longest_m = std::max(longest_m, path_m * std::clamp(turns, 1.0, most_turns));
        }
        entered *= twice_through(stack.layers[first], k);
    }
    return longest_m;
}

}  // namespace

double layer_path_m(const Stack& stack) {
    if (!has_grain(stack)) return path_without_grain(stack);
    const PrincipalStacks principal = principal_stacks(stack);
    return std::max(path_without_grain(principal.along), path_without_grain(principal.across));
}

}  // namespace specula
