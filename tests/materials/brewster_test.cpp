#include "materials/brewster.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

double degrees(double angle_rad) {
    return angle_rad * 180.0 / pi;
}

TEST_CASE("the least TM reflection lies where the reference finds it", "[brewster][reference]") {
    const auto reference = reference_case("M01_fresnel");
    const auto& tolerance = reference.at("tolerance");
    int n_angles = 0;
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        if (!inp.contains("quantity")) continue;
        ++n_angles;
        INFO(inp.dump());
        const BrewsterAngle found = brewster_angle({complex_of(inp.at("eps"))});
        CHECK(std::abs(degrees(found.incidence_rad) - expect.at("theta_deg").get<double>()) <
              tolerance.at("angle_deg").get<double>());
        CHECK(std::abs(found.reflection_tm - expect.at("abs_r_TM").get<double>()) < 1e-7);
    }
    CHECK(n_angles == 7);
}

TEST_CASE("without losses it is Brewster's: tan = n, and nothing comes back", "[brewster]") {
    for (const double permittivity : {1.05, 2.05, 3.8, 9.8}) {
        const BrewsterAngle found = brewster_angle({permittivity});
        CHECK(std::tan(found.incidence_rad) == Approx(std::sqrt(permittivity)));
        CHECK(found.reflection_tm < 1e-15);
    }
}

TEST_CASE("no other angle reflects less", "[brewster]") {
    for (const Complex eps : {Complex(2.0, -0.11), Complex(10.9, -19.7), Complex(1.0, -4e5)}) {
        const BrewsterAngle found = brewster_angle({eps});
        for (double sine = 0.0; sine < 1.0; sine += 0.001)
            CHECK(std::abs(fresnel(Electrics{}, {eps}, sine * sine).tm) >=
                  found.reflection_tm - 1e-15);
    }
}

}  // namespace
}  // namespace specula
