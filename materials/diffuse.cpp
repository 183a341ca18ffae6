#include "materials/diffuse.hpp"

#include <array>
#include <cmath>

#include "materials/rough_face.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// Waves that meet a face: reflected by it, passed through twice, and with one or two turns below.
constexpr std::size_t n_waves = 4;
constexpr int most_orders = 2000;
constexpr double negligible = 1e-12;

/// One wave of a face with heights: amplitude * exp(j rate height).
struct ModulatedWave {
    Complex amplitude;
    double rate_rad_m = 0.0;
};
using Waves = std::array<ModulatedWave, n_waves>;

/// A stack cut at one face, for one polarisation.
struct Cut {
    Complex reflection;  ///< of the face alone
    Complex below;       ///< of all beneath, referred to just under the face
    Complex transfer;    ///< change of the whole stack's reflection with that of this face
};

const Electrics& medium_above(const Stack& stack, int face) {
    static const Electrics air;
    return face > 0 ? stack.layers[static_cast<std::size_t>(face - 1)].medium : air;
}

const Electrics* medium_below(const Stack& stack, int face) {
    if (face < static_cast<int>(stack.layers.size()))
        return &stack.layers[static_cast<std::size_t>(face)].medium;
    const auto* half_space = std::get_if<HalfSpace>(&stack.backing);
    return half_space ? &half_space->medium : nullptr;
}

/// One face under a wave: coefficients and coherent losses.
struct FaceHere {
    Reflection r;
    FaceLoss loss;
};

class CutStack {
  public:
    CutStack(const Stack& stack, double cos_incidence)
        : stack_(stack),
          sin_squared_(1.0 - cos_incidence * cos_incidence),
          k_(two_pi * stack.frequency_hz / speed_of_light_m_s) {}

    Cut at(int face, Complex Reflection::*polarisation) const {
        const int last = static_cast<int>(stack_.layers.size());
        Cut cut{.reflection = here(face).r.*polarisation, .below = 0.0, .transfer = 1.0};
        Complex below = 0.0;
        for (int i = last; i >= 0; --i) {
            const FaceHere f = here(i);
            const Complex r = f.r.*polarisation;
            const Complex round = 1.0 + r * f.loss.reflect_below * below;
            if (i == face) cut.below = below;
            const Complex through = (1.0 - r * r) * f.loss.transmit_twice;
            if (i < face) cut.transfer *= through / (round * round);
            below = (r * f.loss.reflect_above + through * below / round);
            if (i > 0) below *= twice(i - 1);
            if (i > 0 && i <= face) cut.transfer *= twice(i - 1);
        }
        return cut;
    }

    Waves waves(int face, const Cut& cut) const {
        const Electrics* under = medium_below(stack_, face);
        const double above = wave(medium_above(stack_, face));
        const double below = under ? wave(*under) : 0.0;
        const double past = std::copysign(std::sqrt(2.0), above - below) * (above - below);
        Waves waves{};
        waves[0] = {cut.transfer * cut.reflection, 2.0 * above};
        Complex amplitude = cut.transfer * (1.0 - cut.reflection * cut.reflection) * cut.below;
        for (std::size_t turns = 0; turns + 1 < n_waves; ++turns) {
            const double rate = std::hypot(past, 2.0 * below * std::sqrt(double(turns)));
            waves[turns + 1] = {amplitude, std::copysign(rate, above - below)};
            amplitude *= -cut.reflection * cut.below;
        }
        return waves;
    }

    /// Spectrum of all orders of the face's heights, with the phase of what it has in common with
    /// the wave reflected by the face alone.
    Complex spectrum(const StackFace& face, const Waves& waves) const {
        const double across = std::pow(k_ * face.correlation_m, 2) * sin_squared_;  // (K l / 2)^2
        std::array<double, n_waves> share{}, phase{};
        double largest = 0.0;
        for (std::size_t w = 0; w < n_waves; ++w) {
            phase[w] = waves[w].rate_rad_m * face.roughness_m;
            share[w] = std::exp(-0.5 * phase[w] * phase[w]);
            largest = std::max(largest, phase[w] * phase[w]);
        }
        double power = 0.0;
        Complex common = 0.0;
        for (int n = 1; n <= most_orders; ++n) {
            Complex amplitude = 0.0;
            for (std::size_t w = 0; w < n_waves; ++w) {
                share[w] *= phase[w] / std::sqrt(double(n));
                amplitude += waves[w].amplitude * share[w];
            }
            const double of_order =
                pi * face.correlation_m * face.correlation_m / n * std::exp(-across / n);
            const double term = std::norm(amplitude) * of_order;
            power += term;
            common += amplitude * share[0] * of_order;
            if (n > largest + across && term <= negligible * power) break;
        }
        const double size = std::abs(common);
        return size > 0.0 ? std::sqrt(power) / size * common : Complex(std::sqrt(power));
    }

  private:
    double wave(const Electrics& medium) const {
        return k_ * longitudinal_wavenumber(medium, sin_squared_).real();
    }
    Complex twice(int layer) const {
        const Layer& l = stack_.layers[static_cast<std::size_t>(layer)];
        return std::exp(Complex(0.0, -2.0 * k_ * l.thickness_m) *
                        longitudinal_wavenumber(l.medium, sin_squared_));
    }
    FaceHere here(int face) const {
        const Electrics& above = medium_above(stack_, face);
        const Electrics* below = medium_below(stack_, face);
        const double roughness_m = face_of(stack_, face).roughness_m;
        return {below ? fresnel(above, *below, sin_squared_) : pec_reflection,
                face_loss({above, below ? *below : above, roughness_m}, k_, sin_squared_)};
    }

    const Stack& stack_;
    double sin_squared_;
    double k_;
};

Reflection without_grain(const Stack& stack, const StackFace& face, double cos_incidence) {
    const CutStack cut(stack, cos_incidence);
    const auto of = [&](Complex Reflection::*polarisation) {
        return cut.spectrum(face, cut.waves(face.number, cut.at(face.number, polarisation)));
    };
    return {of(&Reflection::te), of(&Reflection::tm)};
}

}  // namespace

int n_faces(const Stack& stack) {
    return static_cast<int>(stack.layers.size()) + 1;
}

StackFace face_of(const Stack& stack, int number) {
    SPECULA_EXPECT(number >= 0 && number < n_faces(stack));
    if (number + 1 < n_faces(stack)) {
        const Layer& layer = stack.layers[static_cast<std::size_t>(number)];
        return {number, layer.roughness_m, layer.correlation_m};
    }
    return std::visit(
        [&](const auto& backing) {
            return StackFace{number, backing.roughness_m, backing.correlation_m};
        },
        stack.backing);
}

Reflection diffuse_reflection(const Stack& stack, const StackFace& face, double cos_incidence) {
    SPECULA_EXPECT(cos_incidence > 0.0 && cos_incidence <= 1.0);
    SPECULA_EXPECT(face.number >= 0 && face.number < n_faces(stack));
    if (face.roughness_m == 0.0) return {};
    if (!has_grain(stack)) return without_grain(stack, face, cos_incidence);
    const PrincipalStacks principal = principal_stacks(stack);
    const Reflection along = without_grain(principal.along, face, cos_incidence);
    const Reflection across = without_grain(principal.across, face, cos_incidence);
    const double cosine = std::cos(stack.grain_to_field_rad), share = cosine * cosine;
    return {share * along.te + (1.0 - share) * across.te,
            share * along.tm + (1.0 - share) * across.tm};
}

double diffuse_over_mirror(const Stack& stack, const StackFace& face) {
    const Reflection spectrum = diffuse_reflection(stack, face, 1.0);
    const double wavelength_m = speed_of_light_m_s / stack.frequency_hz;
    return 4.0 * pi * std::max(std::norm(spectrum.te), std::norm(spectrum.tm)) /
           (wavelength_m * wavelength_m);
}

}  // namespace specula
