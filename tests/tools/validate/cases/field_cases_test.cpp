#include <cmath>

#include "materials/stack.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"

// Antennas, planes and path sums that no reference file has.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

/// Beta function: the integral of cos^n over a half turn is B((n + 1)/2, 1/2).
double cosine_integral(double n) {
    return std::exp(std::lgamma(0.5 * (n + 1.0)) + std::lgamma(0.5) - std::lgamma(0.5 * n + 1.0));
}

TEST_CASE("other patches radiate what their beta functions say", "[validate][E02]") {
    for (const auto& [az_deg, el_deg] : {std::pair{48.0, 21.0}, {6.0, 4.0}, {88.0, 70.0}}) {
        INFO(az_deg << " by " << el_deg << " degrees");
        const double na = std::log(std::pow(10.0, -0.6)) / std::log(std::cos(az_deg * pi / 180.0));
        const double ne = std::log(std::pow(10.0, -0.6)) / std::log(std::cos(el_deg * pi / 180.0));
        const double integral =
            std::pow(10.0, 0.71) * cosine_integral(na) * cosine_integral(ne + 1.0);
        check_passes(case_of("E02_pattern_norm",
                             {{"G0_dbi", 7.1}, {"az6_deg", az_deg}, {"el6_deg", el_deg}},
                             {{"integral_G_dOmega", integral},
                              {"efficiency", integral / (4.0 * pi)},
                              {"directivity_dbi", 7.1 - 10.0 * std::log10(integral / (4.0 * pi))},
                              {"nA", na},
                              {"nE", ne}},
                             {{"rel", 1e-7}}));
    }
}

TEST_CASE("another plate intercepts its solid angle; a huge one, half of everything",
          "[validate][E04]") {
    const double half = 0.085, h = 0.31;
    const double omega = 4.0 * std::asin(half * half / (half * half + h * h));
    check_passes(case_of("E04_intercepted_power", {{"antenna", "iso"}, {"L_m", 0.17}, {"H_m", h}},
                         {{"fraction", omega / (4.0 * pi)}, {"closed_form", omega / (4.0 * pi)}},
                         {{"rel", 1e-9}}));
    check_passes(case_of("E04_intercepted_power", {{"antenna", "iso"}, {"L_m", 60.0}, {"H_m", 0.3}},
                         {{"fraction", 0.4954984}}, {{"rel", 1e-5}}));
    CHECK(validated(case_of("E04_intercepted_power",
                            {{"antenna", "horn"}, {"L_m", 0.1}, {"H_m", 0.3}}, {{"fraction", 0.1}},
                            {{"rel", 1e-3}}))
              .verdict() == Verdict::not_computable);
}

C exact_dipole(const Json& inp) {
    const CaseVerdict verdict =
        validated(case_of("N01_infinite_plane", inp, {{"exact_dipole_over_G", {{"h", {1, 0}}}}},
                          {{"db", 1e3}, {"phase_deg", 360}}));
    return std::get<C>(computed(verdict, "exact_dipole_over_G.h (level)"));
}

TEST_CASE("over a conductor the spectral integral is the dipole's image, near terms and all",
          "[validate][N01]") {
    for (const double height_m : {0.45, 0.05, 0.0061}) {
        const double f_hz = 61.3e9, k = two_pi * f_hz / 299792458.0, r = 2.0 * height_m;
        const C jkr(0.0, k * r);
        const C image = -299792458.0 / f_hz / (4.0 * pi * r) * std::exp(-jkr) *
                        (1.0 + 1.0 / jkr + 1.0 / (jkr * jkr));
        const C h = exact_dipole({{"f_hz", f_hz}, {"H_m", height_m}, {"surface", "PEC"}});
        CHECK(std::abs(h / image - 1.0) < 1e-11);
    }
}

/// The waves that reach the plane at less than 84 degrees, fading out smoothly from 53 on, by the
/// trapezoidal rule over real angles and with the simulator's own reflection: what is left out has
/// no end of its own and dies like exp(-sqrt(kH)).
C over_real_angles(const Stack& stack, double height_m) {
    const double wavelength_m = 299792458.0 / stack.frequency_hz, k = two_pi / wavelength_m;
    constexpr int n = 40000;
    constexpr double low = 0.1, high = 0.6;
    C sum = 0.0;
    for (int i = 1; i <= n; ++i) {
        const double c = low + (1.0 - low) * i / n;
        const double u = (c - low) / (high - low);
        const double fade = c >= high ? 1.0 : 1.0 / (1.0 + std::exp(1.0 / u - 1.0 / (1.0 - u)));
        const Reflection r = stack_reflection(stack, c);
        sum += (i == n ? 0.5 : 1.0) * fade * (r.te - c * c * r.tm) *
               std::polar(1.0, -2.0 * k * c * height_m);
    }
    // Trapezoids err at their end, c = 1, by step^2/12 of the slope there, which is -2jkH.
    const double step = (1.0 - low) / n;
    const Reflection r = stack_reflection(stack, 1.0);
    const C end = (r.te - r.tm) * std::polar(1.0, -2.0 * k * height_m);
    const C slope = C(0.0, -2.0 * k * height_m) * end;
    return C(0.0, -wavelength_m / (8.0 * pi)) * k * (sum * step - slope * step * step / 12.0);
}

TEST_CASE("over other slabs and half-spaces it agrees with the sum over real angles",
          "[validate][N01]") {
    const double f_hz = 59.1e9, height_m = 0.21;
    const C eps(3.3, -0.21);
    const Stack slab{.layers = {{.medium = {.permittivity = eps}, .thickness_m = 0.0068}},
                     .frequency_hz = f_hz};
    const C h = exact_dipole({{"f_hz", f_hz},
                              {"H_m", height_m},
                              {"surface", "made-up slab"},
                              {"eps", pair_of(eps)},
                              {"d_m", 0.0068}});
    CHECK(std::abs(h / over_real_angles(slab, height_m) - 1.0) < 1e-6);

    const Stack ground{.backing = HalfSpace{.medium = {.permittivity = eps}}, .frequency_hz = f_hz};
    const C below = exact_dipole({{"f_hz", f_hz},
                                  {"H_m", height_m},
                                  {"surface", "made-up half-space"},
                                  {"eps", pair_of(eps)}});
    CHECK(std::abs(below / over_real_angles(ground, height_m) - 1.0) < 1e-6);
}

TEST_CASE("the image of a plane is its reflection at normal incidence", "[validate][N01]") {
    const double f_hz = 70e9, k = two_pi * f_hz / 299792458.0;
    const C n = std::sqrt(C(4.0, -0.5));
    const C h = (1.0 - n) / (1.0 + n) * 2.0 / (4.0 * k * 0.4) * std::polar(1.0, -2.0 * k * 0.4);
    check_passes(
        case_of("N01_infinite_plane",
                {{"f_hz", f_hz},
                 {"H_m", 0.4},
                 {"surface", "made-up half-space"},
                 {"eps", {4.0, -0.5}},
                 {"G", 2.0}},
                {{"image_source", {{"h", pair_of(h)}, {"abs_db", 20.0 * std::log10(std::abs(h))}}}},
                {{"db", 1e-9}, {"phase_deg", 1e-9}}));
    CHECK(
        validated(case_of("N01_infinite_plane", {{"f_hz", f_hz}, {"H_m", 0.4}, {"surface", "sea"}},
                          {{"image_source", {{"h", {1, 0}}}}}, {{"db", 1}, {"phase_deg", 1}}))
            .verdict() == Verdict::not_computable);
}

TEST_CASE("other paths add up at every frequency", "[validate][U01]") {
    Json re = Json::array(), im = Json::array();
    for (int n = 0; n < 32; ++n) {
        const double f_hz = 24e9 + 1e9 * n / 32;
        const C h = C(0.5, -1.0) * std::polar(1.0, -two_pi * f_hz * 3.1e-9) +
                    C(0.0, 2.0) * std::polar(1.0, -two_pi * f_hz * 17.3e-9);
        re.push_back(h.real());
        im.push_back(h.imag());
    }
    const Json inp{
        {"f0_hz", 24e9},        {"B_hz", 1e9},          {"N", 32}, {"tau_s", {3.1e-9, 17.3e-9}},
        {"amp_re", {0.5, 0.0}}, {"amp_im", {-1.0, 2.0}}};
    check_passes(case_of("U01_path_sum", inp, {{"h_re", re}, {"h_im", im}}, {{"rel_l2", 1e-10}}));
    re[5] = re[5].get<double>() + 0.1;
    CHECK(validated(case_of("U01_path_sum", inp, {{"h_re", re}, {"h_im", im}}, {{"rel_l2", 1e-3}}))
              .verdict() == Verdict::fail);
}

}  // namespace
}  // namespace specula
