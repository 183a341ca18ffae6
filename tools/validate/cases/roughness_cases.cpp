#include "materials/interface.hpp"
#include "materials/rough_face.hpp"
#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

std::vector<Quantity> roughness_point(const CasePoint& point) {
    const RoughIncidence rough{.frequency_hz = frequency_of(point.inp),
                               .roughness_m = point.inp.number("rms_m", Range::at_least(0.0)),
                               .cos_incidence = cos_incidence_of(point.inp)};
    const Electrics air;
    const double wavenumber_rad_m = two_pi * rough.frequency_hz / speed_of_light_m_s;
    const FaceLoss loss = face_loss({air, air, rough.roughness_m}, wavenumber_rad_m,
                                    1.0 - rough.cos_incidence * rough.cos_incidence);
    const double phase_rad = rayleigh_parameter(rough);
    Comparison compare(point);
    compare.relative("field_factor", loss.reflect_above, "rel");
    compare.relative("power_db", level_db(loss.reflect_above), "rel");
    compare.relative("rayleigh_parameter_2ks_cos", phase_rad, "rel");
    compare.exact("is_rayleigh_smooth", phase_rad < 0.5 * pi);
    return compare.finish();
}

}  // namespace specula
