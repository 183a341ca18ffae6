#include "materials/diffuse.hpp"

#include <array>
#include <cmath>

#include "materials/stack_faces.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// Waves that meet a face: reflected by it, passed through twice, and with one or two turns below.
constexpr std::size_t n_waves = 4;
constexpr int most_orders = 2000;
constexpr double negligible = 1e-12;

/// Both polarisations.
struct TeTm {
    Complex te, tm;
};

/// Waves of a face with heights: amplitude * exp(j rate height). Rates know no polarisation.
struct ModulatedWaves {
    std::array<TeTm, n_waves> amplitude{};
    std::array<double, n_waves> rate_rad_m{};
};

/// A stack cut at one face, for one polarisation.
struct Cut {
    Complex reflection;  ///< of the face alone
    Complex below;       ///< of all beneath, referred to just under the face
    Complex transfer;    ///< change of the whole stack's reflection with that of this face
};

Cut cut_at(std::size_t number, std::span<const FaceUnderWave> faces,
           Complex Reflection::*polarisation) {
    Cut cut{.reflection = faces[number].reflection.*polarisation, .below = 0.0, .transfer = 1.0};
    Complex below = 0.0;
    for (std::size_t i = faces.size(); i-- > 0;) {
        const Complex r = faces[i].reflection.*polarisation;
        const FaceLoss& loss = faces[i].loss;
        const Complex round = 1.0 + r * loss.reflect_below * below;
        if (i == number) cut.below = below;
        const Complex through = (1.0 - r * r) * loss.transmit_twice;
        if (i < number) cut.transfer *= quotient(through, round * round);
        below = r * loss.reflect_above + quotient(through * below, round);
        if (i == 0) break;
        const Complex twice = faces[i - 1].pass * faces[i - 1].pass;
        below *= twice;
        if (i <= number) cut.transfer *= twice;
    }
    return cut;
}

std::array<Complex, n_waves> amplitudes_of(const Cut& cut) {
    std::array<Complex, n_waves> amplitudes{cut.transfer * cut.reflection};
    Complex amplitude = cut.transfer * (1.0 - cut.reflection * cut.reflection) * cut.below;
    for (std::size_t turns = 0; turns + 1 < n_waves; ++turns) {
        amplitudes[turns + 1] = amplitude;
        amplitude *= -cut.reflection * cut.below;
    }
    return amplitudes;
}

ModulatedWaves waves_at(std::size_t number, std::span<const FaceUnderWave> faces, double k) {
    ModulatedWaves waves;
    const auto te = amplitudes_of(cut_at(number, faces, &Reflection::te));
    const auto tm = amplitudes_of(cut_at(number, faces, &Reflection::tm));
    for (std::size_t w = 0; w < n_waves; ++w) waves.amplitude[w] = {te[w], tm[w]};
    const double above = k * faces[number].q_above.real(), below = k * faces[number].q_below.real();
    const double past = std::copysign(std::sqrt(2.0), above - below) * (above - below);
    waves.rate_rad_m[0] = 2.0 * above;
    for (std::size_t turns = 0; turns + 1 < n_waves; ++turns) {
        const double rate = std::sqrt(past * past + 4.0 * below * below * double(turns));
        waves.rate_rad_m[turns + 1] = std::copysign(rate, above - below);
    }
    return waves;
}

/// Power over the orders so far, and what they have in common with the wave reflected by the face
/// alone.
class OrderSum {
  public:
    void add(Complex amplitude, double first_share, double of_order) {
        const double term = std::norm(amplitude) * of_order;
        power_ += term;
        common_ += amplitude * first_share * of_order;
        has_ended_ = term <= negligible * power_;
    }
    bool has_ended() const { return has_ended_; }

    Complex value() const {
        const double size = std::sqrt(std::norm(common_));
        return size > 0.0 ? std::sqrt(power_) / size * common_ : Complex(std::sqrt(power_));
    }

  private:
    double power_ = 0.0;
    Complex common_ = 0.0;
    bool has_ended_ = false;
};

/// Spectrum of all orders of the face's heights.
/// @in  across  (K l / 2)^2
Reflection spectrum(const StackFace& face, const ModulatedWaves& waves, double across) {
    std::array<double, n_waves> share{}, phase{};
    double largest = 0.0;
    for (std::size_t w = 0; w < n_waves; ++w) {
        phase[w] = waves.rate_rad_m[w] * face.roughness_m;
        share[w] = std::exp(-0.5 * phase[w] * phase[w]);
        largest = std::max(largest, phase[w] * phase[w]);
    }
    OrderSum te, tm;
    for (int n = 1; n <= most_orders; ++n) {
        TeTm amplitude{};
        const double per_root = 1.0 / std::sqrt(double(n));
        for (std::size_t w = 0; w < n_waves; ++w) {
            share[w] *= phase[w] * per_root;
            amplitude.te += waves.amplitude[w].te * share[w];
            amplitude.tm += waves.amplitude[w].tm * share[w];
        }
        const double of_order =
            pi * face.correlation_m * face.correlation_m / n * std::exp(-across / n);
        te.add(amplitude.te, share[0], of_order);
        tm.add(amplitude.tm, share[0], of_order);
        if (n > largest + across && te.has_ended() && tm.has_ended()) break;
    }
    return {te.value(), tm.value()};
}

Reflection without_grain(const Stack& stack, const StackFace& face, double cos_incidence) {
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    const double sin_squared = 1.0 - cos_incidence * cos_incidence;
    const double across = std::pow(k * face.correlation_m, 2) * sin_squared;
    const FacesUnderWave under(stack, cos_incidence);
    const std::span<const FaceUnderWave> faces = under.all();
    return spectrum(face, waves_at(static_cast<std::size_t>(face.number), faces, k), across);
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
