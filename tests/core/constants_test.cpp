#include "sim/core/constants.hpp"

#include "sim/core/literals.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

using namespace literals;

TEST_CASE("derived constants agree with CODATA 2018 and with each other", "[constants]") {
    constexpr double rounding = 1e-15;
    CHECK(vacuum_permittivity_f_m * vacuum_permeability_h_m * speed_of_light_m_s *
              speed_of_light_m_s ==
          Approx(1.0).epsilon(rounding));
    CHECK(vacuum_impedance_ohm * vacuum_impedance_ohm * vacuum_permittivity_f_m ==
          Approx(vacuum_permeability_h_m).epsilon(rounding));
    CHECK(two_pi == 2.0 * pi);
    // CODATA's own digits: the last one printed may be off by half, that of mu0 by 4e-12 of it.
    CHECK(vacuum_permittivity_f_m == Approx(8.854'187'8128e-12).epsilon(1e-11));
    CHECK(vacuum_impedance_ohm == Approx(376.730'313'668).epsilon(4e-12));
}

TEST_CASE("literals of units are the numbers they stand for", "[constants]") {
    // Conversion multiplies by a rounded power of ten: half an ulp twice.
    constexpr double ulp = 2.3e-16;
    CHECK(450.0_mm == Approx(0.45).epsilon(ulp));
    CHECK(45.0_cm == Approx(0.45).epsilon(ulp));
    CHECK(0.45_m == 0.45);
    CHECK(25.0_um == Approx(25e-6).epsilon(ulp));
    CHECK(60.0_GHz == 60e9);
    CHECK(5.0_MHz == 5e6);
    CHECK(180.0_deg == Approx(pi).epsilon(ulp));
}

}  // namespace
}  // namespace specula
