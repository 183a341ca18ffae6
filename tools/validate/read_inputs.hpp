#pragma once

#include "materials/stack.hpp"
#include "scenes/antenna.hpp"
#include "scenes/chirp.hpp"
#include "tools/validate/fields.hpp"

namespace specula {

/// The longest chirp and the longest transform that cases may ask for: sums are written out.
inline constexpr int most_samples = 1 << 14;
inline constexpr int longest_transform = 1 << 16;

/// What several kinds of cases give in the same way.

/// Cosine of `theta_deg`, 0 to below 90.
double cos_incidence_of(const Fields& inp);

/// `f_hz` or `f`, 1 kHz to 10 THz.
double frequency_of(const Fields& inp);

/// `f0_hz`, `B_hz`, `N`, `fs_hz` (or `f0`, `B`, `fs`): samples from the start of the ramp.
Chirp chirp_of(const Fields& inp);
/// The same where the sample rate may be left out.
Chirp chirp_of(const Fields& inp, double usual_rate_hz);

/// One layer, `eps` and `d_m`, in air.
Stack slab_of(const Fields& inp);

/// "pec", or a relative permittivity.
Backing backing_of(const Fields& inp, const std::string& name);

/// "iso", or "patch": 5.5 dBi, half widths of 60 and 35 degrees at -6 dB.
Pattern antenna_of(const Fields& inp, const std::string& name);

std::string lower_case(std::string text);

}  // namespace specula
