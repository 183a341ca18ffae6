#include "materials/interface.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

double sin_squared(double theta_deg) {
    const double s = std::sin(theta_deg * pi / 180.0);
    return s * s;
}

Reflection from_air(Complex permittivity, double theta_deg) {
    return fresnel({}, {.permittivity = permittivity}, sin_squared(theta_deg));
}

/// The angle of the least |r_tm| within a degree of a guess, to 0.0005 degrees.
double least_tm_deg(Complex permittivity, double guess_deg) {
    double best_deg = 0.0, least = 2.0;
    for (int i = -2000; i <= 2000; ++i) {
        const double theta_deg = guess_deg + i * 0.0005;
        const double size = std::abs(from_air(permittivity, theta_deg).tm);
        if (size < least) least = size, best_deg = theta_deg;
    }
    return best_deg;
}

TEST_CASE("half-spaces reflect as the reference says", "[interface][reference]") {
    const auto reference = reference_case("M01_fresnel");
    const double tolerance = reference.at("tolerance").at("abs");
    const double angle_deg = reference.at("tolerance").at("angle_deg");
    int n_angles = 0, n_brewster = 0;
    for (const auto& point : reference.at("points")) {
        const Complex eps = complex_of(point.at("inp").at("eps"));
        const auto& expect = point.at("expect");
        if (point.at("inp").contains("theta_deg")) {
            const Reflection r = from_air(eps, point.at("inp").at("theta_deg"));
            CHECK(std::abs(r.te - complex_of(expect.at("r_TE"))) < tolerance);
            CHECK(std::abs(r.tm - complex_of(expect.at("r_TM"))) < tolerance);
            ++n_angles;
        } else {
            const double brewster_deg = expect.at("theta_deg");
            CHECK(std::abs(least_tm_deg(eps, brewster_deg) - brewster_deg) < angle_deg);
            // A lossless medium has a true zero there; a lossy one this much is left.
            CHECK(std::abs(std::abs(from_air(eps, brewster_deg).tm) -
                           expect.at("abs_r_TM").get<double>()) < tolerance);
            ++n_brewster;
        }
    }
    CHECK(n_angles == 72);
    CHECK(n_brewster == 7);
}

TEST_CASE("at normal incidence the polarisations differ in sign only", "[interface]") {
    for (const Complex eps : {Complex(2.6, 0.0), Complex(6.3, -0.9), Complex(1.0, -1e7)}) {
        const Reflection r = from_air(eps, 0.0);
        CHECK(std::abs(r.te + r.tm) < 1e-15);
        const Complex n = std::sqrt(eps);
        CHECK(std::abs(r.te - (1.0 - n) / (1.0 + n)) < 1e-15);
    }
}

TEST_CASE("at Brewster's angle a lossless half-space reflects no TM", "[interface]") {
    for (const double eps : {1.5, 2.6, 7.5}) {
        const double s2 = eps / (1.0 + eps);  // tan(theta) = n
        CHECK(std::abs(fresnel({}, {.permittivity = eps}, s2).tm) < 1e-15);
        CHECK(std::abs(fresnel({}, {.permittivity = eps}, s2).te) ==
              Approx((eps - 1.0) / (eps + 1.0)).epsilon(1e-14));
    }
}

TEST_CASE("at grazing incidence every half-space becomes a mirror", "[interface]") {
    for (const Complex eps : {Complex(1.48, -0.03), Complex(7.5, -0.15), Complex(1.0, -1e7)}) {
        const Reflection r = fresnel({}, {.permittivity = eps}, 1.0);
        CHECK(std::abs(r.te + 1.0) < 1e-15);
        CHECK(std::abs(r.tm + 1.0) < 1e-15);
    }
}

TEST_CASE("a perfect conductor is the limit of a good one", "[interface]") {
    for (const double theta_deg : {0.0, 45.0, 80.0}) {
        // |1 - |r|| is of the order 2 sqrt(2 / eps'') / cos.
        const Reflection r = from_air({1.0, -1e14}, theta_deg);
        CHECK(std::abs(r.te - pec_reflection.te) < 2e-6);
        CHECK(std::abs(r.tm - pec_reflection.tm) < 2e-6);
    }
}

TEST_CASE("between equal media there is no face, whatever the angle", "[interface]") {
    for (const Electrics& medium : {Electrics{}, Electrics{{2.6, -0.1}, 1.0}, Electrics{{1, -9}, 2.0}})
        for (const double s2 : {0.0, 0.5, 1.0}) {
            const Reflection r = fresnel(medium, medium, s2);
            CHECK(r.te == Complex(0.0));
            CHECK(r.tm == Complex(0.0));
        }
}

TEST_CASE("seen from the other side a face reflects with the other sign", "[interface]") {
    const Electrics air, glass{{6.31, -0.26}, 1.0}, steel{{1.0, -3e6}, 2.0};
    for (const double s2 : {0.0, 0.3, 0.99})
        for (const auto& [one, other] : {std::pair{air, glass}, {glass, steel}}) {
            const Reflection down = fresnel(one, other, s2), up = fresnel(other, one, s2);
            CHECK(std::abs(down.te + up.te) < 1e-15);
            CHECK(std::abs(down.tm + up.tm) < 1e-15);
        }
}

TEST_CASE("waves decay into lossy and evanescent media, and run on in lossless ones",
          "[interface]") {
    CHECK(longitudinal_wavenumber({}, 0.0) == Complex(1.0, 0.0));
    CHECK(longitudinal_wavenumber({}, 0.75).real() == Approx(0.5));
    for (const double imag : {0.0, -0.0}) {  // a square root changes sign with that of a zero
        CHECK(longitudinal_wavenumber({{2.6, imag}, 1.0}, 0.5).real() > 0.0);
        const Complex evanescent = longitudinal_wavenumber({{0.5, imag}, 1.0}, 0.75);
        CHECK(std::abs(evanescent - Complex(0.0, -0.5)) < 1e-15);
    }
    const Complex lossy = longitudinal_wavenumber({{2.6, -0.1}, 1.0}, 0.5);
    CHECK(lossy.real() > 0.0);
    CHECK(lossy.imag() < 0.0);
}

}  // namespace
}  // namespace specula
