#include "materials/diffuse.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double frequency_hz = 60e9;
const double k = two_pi * frequency_hz / speed_of_light_m_s;

Stack rough_metal(double roughness_m, double correlation_m) {
    return {{}, PerfectConductor{roughness_m, correlation_m}, frequency_hz};
}

double spectrum_of(const Stack& stack, double cosine) {
    return std::norm(diffuse_reflection(stack, face_of(stack, 0), cosine).te);
}

/// The integral of the covariance e^{-x} (e^{x rho} - 1) of exp(j v height), x = (v s)^2, over the
/// distance, by the midpoint rule: no series in it.
double integrated_covariance(double roughness_m, double correlation_m, double cosine) {
    const double x = std::pow(2.0 * k * roughness_m * cosine, 2);
    const double across = 2.0 * k * std::sqrt(1.0 - cosine * cosine);
    const double step_m = correlation_m / 2000.0;
    double sum = 0.0;
    for (int i = 0; i < 12000; ++i) {
        const double d = (i + 0.5) * step_m;
        const double rho = std::exp(-std::pow(d / correlation_m, 2));
        sum += std::exp(-x) * std::expm1(x * rho) * std::cyl_bessel_j(0.0, across * d) * d;
    }
    return two_pi * sum * step_m;
}

TEST_CASE("the diffuse spectrum of a conductor is the transform of its heights' covariance",
          "[diffuse]") {
    for (const double roughness_m : {2e-5, 1e-4, 4e-4, 1.2e-3})
        for (const double cosine : {1.0, 0.985, 0.9}) {
            INFO(roughness_m << " m rms, cosine " << cosine);
            // 1e-6: the midpoint rule.
            CHECK(spectrum_of(rough_metal(roughness_m, 3e-3), cosine) ==
                  Approx(integrated_covariance(roughness_m, 3e-3, cosine)).epsilon(1e-6));
        }
}

TEST_CASE("small heights scatter as small perturbations of first order say", "[diffuse]") {
    const double roughness_m = 2e-6, correlation_m = 1.5e-3;
    const Electrics stone{.permittivity = {6.8, -0.1}};
    Stack stack{{}, HalfSpace{stone, roughness_m, correlation_m}, frequency_hz};
    const double r = std::abs(fresnel({}, stone, 0.0).te);
    // sigma0 = 4 |R|^2 (ks)^2 (kl)^2 head-on; of the spectrum sigma0 = 4 pi S cos^2 / lambda^2.
    const double sigma0 =
        4.0 * r * r * std::pow(k * roughness_m, 2) * std::pow(k * correlation_m, 2);
    const double wavelength_m = two_pi / k;
    // The next order is (2ks)^2 = 2.5e-5 of it.
    CHECK(4.0 * pi * spectrum_of(stack, 1.0) / (wavelength_m * wavelength_m) ==
          Approx(sigma0).epsilon(1e-4));
    CHECK(diffuse_over_mirror(stack, face_of(stack, 0)) == Approx(sigma0).epsilon(1e-4));
}

TEST_CASE("what a rough face loses from its coherent echo it scatters, and no more", "[diffuse]") {
    const double correlation_m = 0.05;  // so long that all of it stays within 5 degrees
    const Electrics stone{.permittivity = {6.8, -0.1}};
    for (const double roughness_m : {5e-5, 2e-4, 6e-4}) {
        const Stack stack{{}, HalfSpace{stone, roughness_m, correlation_m}, frequency_hz};
        const Stack smooth{{}, HalfSpace{stone}, frequency_hz};
        double diffuse = 0.0;
        const double step = 2e-5;
        for (double sine = 0.5 * step; sine < 0.09; sine += step)
            diffuse += spectrum_of(stack, std::sqrt(1.0 - sine * sine)) * 4.0 * k * k * sine *
                       step / two_pi;
        const double coherent = std::norm(stack_reflection(stack, 1.0).te);
        const double all = std::norm(stack_reflection(smooth, 1.0).te);
        INFO(roughness_m << " m rms");
        // 0.5 %: reflection and phase of the heights change that much within 5 degrees.
        CHECK((coherent + diffuse) / all == Approx(1.0).margin(0.005));
    }
}

TEST_CASE("a buried rough conductor scatters as the stack's reflection changes with its depth",
          "[diffuse]") {
    const double roughness_m = 1e-6, correlation_m = 3e-3, depth_m = 3e-3;
    for (const double cosine : {1.0, 0.9}) {
        const auto stack_with = [&](double thickness_m, double heights_m) {
            return Stack{
                {Layer{.medium = {.permittivity = {2.6, -0.03}}, .thickness_m = thickness_m}},
                PerfectConductor{heights_m, correlation_m},
                frequency_hz};
        };
        const double step_m = 1e-8;
        const Reflection more = stack_reflection(stack_with(depth_m - step_m, 0.0), cosine);
        const Reflection less = stack_reflection(stack_with(depth_m + step_m, 0.0), cosine);
        const double across = std::pow(k * correlation_m, 2) * (1.0 - cosine * cosine);
        const double flat = std::sqrt(pi * std::exp(-across)) * correlation_m * roughness_m;
        const Stack rough = stack_with(depth_m, roughness_m);
        const Reflection found = diffuse_reflection(rough, face_of(rough, 1), cosine);
        // Heights of 1 um: second order and the coherent loss are 1e-3; the layer is lossy by 1 %.
        const Complex te = (more.te - less.te) / (2.0 * step_m) * flat;
        const Complex tm = (more.tm - less.tm) / (2.0 * step_m) * flat;
        CHECK(std::abs(found.te) == Approx(std::abs(te)).epsilon(0.01));
        CHECK(std::abs(found.tm) == Approx(std::abs(tm)).epsilon(0.01));
        // Its phase follows the wave down and up: a quarter turn, that of j, is left to the cells.
        CHECK(std::abs(std::arg(found.te / te * Complex(0.0, 1.0))) < 0.02);
    }
}

TEST_CASE("smooth faces scatter nothing, and faces that let all pass neither", "[diffuse]") {
    const Stack smooth = rough_metal(0.0, 1e-3);
    CHECK(diffuse_reflection(smooth, face_of(smooth, 0), 0.9).te == Complex(0.0));
    const Layer nothing{.medium = {}, .thickness_m = 1e-3, .roughness_m = 1e-4};
    const Stack air{{nothing}, HalfSpace{}, frequency_hz};
    CHECK(std::abs(diffuse_reflection(air, face_of(air, 0), 0.9).tm) < 1e-15);
}

}  // namespace
}  // namespace specula
