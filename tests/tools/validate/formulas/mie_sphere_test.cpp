#include "tools/validate/formulas/mie_sphere.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a small sphere scatters as Rayleigh says", "[validate][mie]") {
    for (const double ka : {1e-3, 1e-2}) {
        const double size = std::pow(ka, 4);
        CHECK(conducting_sphere_backscatter(ka) == Approx(9.0 * size).epsilon(2.0 * ka * ka));
        const Complex m(1.7, -0.3), contrast = (m * m - 1.0) / (m * m + 2.0);
        CHECK(dielectric_sphere_backscatter({.ka = ka, .refractive_index = m}) ==
              Approx(4.0 * size * std::norm(contrast)).epsilon(4.0 * ka * ka));
    }
}

TEST_CASE("the sphere series agrees with 60 digits of mpmath", "[validate][mie]") {
    // Sums of spherical Bessel functions of the mpmath library; the rounding of upward recurrences
    // to order ka costs some 1e-11.
    struct Row {
        double ka;
        Complex index;
        double sigma;
    };
    for (const Row& row : {Row{25.0, {2.74, -0.02}, 0.769050851619049},
                           {25.0, {1.61, -0.008}, 0.929794978870361},
                           {200.0, {3.0, -3.0}, 0.520004087392674},
                           {200.0, {1.5, 0.0}, 8.37120850436994},
                           {50.0, {100.0, -100.0}, 0.97494970374749},
                           {pi, {2.0, 0.0}, 4.80212528303625},
                           {0.01, {1.6, -0.01}, 4.68262386925913e-9},
                           {200.0, {2.74, -0.02}, 0.216512194142501}}) {
        INFO("ka " << row.ka << ", index " << row.index);
        CHECK(dielectric_sphere_backscatter({.ka = row.ka, .refractive_index = row.index}) ==
              Approx(row.sigma).epsilon(1e-9));
    }
    CHECK(conducting_sphere_backscatter(200.0) == Approx(0.999917121477545).epsilon(1e-9));
    CHECK(conducting_sphere_backscatter(pi) == Approx(0.756403560691195).epsilon(1e-12));
    CHECK(conducting_sphere_backscatter(3.7) == Approx(1.45433990626152).epsilon(1e-12));
}

TEST_CASE("a sphere of enormous index is a conductor", "[validate][mie]") {
    for (const double ka : {0.5, 3.0, 20.0})
        CHECK(dielectric_sphere_backscatter({.ka = ka, .refractive_index = {1e5, -1e5}}) ==
              Approx(conducting_sphere_backscatter(ka)).epsilon(2e-4));  // 1/|m| of absorption
}

TEST_CASE("a sphere of air is not there", "[validate][mie]") {
    CHECK(dielectric_sphere_backscatter({.ka = 7.0, .refractive_index = 1.0}) < 1e-28);
}

TEST_CASE("a large conducting sphere scatters what its disc catches", "[validate][mie]") {
    CHECK(conducting_sphere_backscatter(1000.0) == Approx(1.0).epsilon(1e-5));
}

}  // namespace
}  // namespace specula
