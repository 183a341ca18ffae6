#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/beat_samples.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

std::vector<Quantity> displacement_point(const CasePoint& point) {
    const double shift_m = point.inp.number("dz_m", Range::between(-10.0, 10.0));
    const double phase_rad =
        beat_phase_rad({.frequency_hz = frequency_of(point.inp), .shift_m = shift_m});
    Comparison compare(point);
    compare.relative("dphase_rad", phase_rad, "rel");
    compare.relative("dphase_deg", phase_rad * 180.0 / pi, "rel");
    return compare.finish();
}

std::vector<Quantity> doppler_point(const CasePoint& point) {
    point.inp.describe({"sign"});
    const double frequency_hz = frequency_of(point.inp);
    const double interval_s = point.inp.number("Tc_s", Range::inside(0.0, 1.0));
    const double velocity_m_s = point.inp.number("v_m_s", Range::between(-1e4, 1e4));
    const int n_chirps = point.inp.count("Nc", Range::at_least(1.0));
    const double shift_m = velocity_m_s * interval_s;
    if (std::abs(shift_m) > 10.0)
        point.inp.fail("v_m_s", "moves by metres between chirps", "use a lower speed");
    const double phase_rad = beat_phase_rad({.frequency_hz = frequency_hz, .shift_m = shift_m});
    const double wrapped_rad = std::remainder(phase_rad, two_pi);
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    Comparison compare(point);
    compare.relative("phase_per_chirp_rad", phase_rad, "rel");
    compare.wrapped("phase_wrapped_rad", wrapped_rad, two_pi, "rel");
    compare.relative("doppler_bin", phase_rad / two_pi * n_chirps, "rel");
    compare.wrapped("doppler_bin_aliased", wrapped_rad / two_pi * n_chirps, n_chirps, "rel");
    compare.relative("v_max_unambiguous", wavelength_m / (4.0 * interval_s), "rel");
    compare.relative("v_res", wavelength_m / (2.0 * n_chirps * interval_s), "rel");
    return compare.finish();
}

}  // namespace specula
