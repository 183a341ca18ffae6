#include <cmath>

#include "materials/brewster.hpp"
#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Where |r_TM| is least. A lossless medium reflects nothing there, which is known to rounding; the
/// least |r_TM| of a lossy one is as exact as the angle is.
std::vector<Quantity> brewster_point(const CasePoint& point, const Electrics& medium) {
    point.inp.describe({"quantity"});
    Comparison compare(point);
    const BrewsterAngle brewster = brewster_angle(medium);
    const double allowed_deg =
        compare.wants("theta_deg") || medium.permittivity.imag() != 0.0
            ? point.tolerance.number("angle_deg", Range::at_least(0.0))
            : 0.0;
    compare.within("theta_deg", brewster.incidence_rad * 180.0 / pi, allowed_deg, "deg");
    if (compare.wants("abs_r_TM")) {
        const double sine = std::sin(brewster.incidence_rad + allowed_deg * pi / 180.0);
        const double beside = std::abs(fresnel(Electrics{}, medium, sine * sine).tm);
        const double exact =
            point.tolerance.number("abs_r_TM_at_brewster", Range::at_least(0.0));
        const bool lossless = medium.permittivity.imag() == 0.0;
        compare.within("abs_r_TM", brewster.reflection_tm,
                       lossless ? exact : std::max(exact, beside - brewster.reflection_tm), "");
    }
    return compare.finish();
}

}  // namespace

std::vector<Quantity> fresnel_point(const CasePoint& point) {
    const Electrics medium{.permittivity = point.inp.permittivity("eps")};
    if (!point.inp.has("theta_deg") && point.inp.has("quantity")) {
        const std::string quantity = lower_case(point.inp.text("quantity"));
        if (quantity.find("brewster") == std::string::npos)
            throw NotComputable("does not know the quantity \"" + quantity + "\"");
        return brewster_point(point, medium);
    }
    const double incidence_rad = point.inp.number("theta_deg", Range::between(0.0, 90.0)) * pi / 180.0;
    const double sine = std::sin(incidence_rad);
    const Reflection r = fresnel(Electrics{}, medium, sine * sine);
    Comparison compare(point);
    compare.absolute("r_TE", r.te, "abs");
    compare.absolute("r_TM", r.tm, "abs");
    return compare.finish();
}

}  // namespace specula
