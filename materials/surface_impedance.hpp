#pragma once

#include "materials/interface.hpp"
#include "materials/models/conductive.hpp"

namespace specula {

/// A good conductor seen as an impedance of its face: what engineers calculate with, and a check on
/// the exact half-space that `fresnel` gives.
/// @eq    PHYSICS.md#surface-impedance; Leontovich 1948
/// Limit: conduction far above displacement current, sigma >> w eps0, and |eps mu| >> 1; metals at
///        60 GHz agree with the exact reflection to 1e-7 dB.
class SurfaceImpedance {
  public:
    SurfaceImpedance(const Conductive& metal, double frequency_hz);

    /// Where the field has fallen to 1/e: sqrt(2 / (w mu sigma)).
    double skin_depth_m() const { return skin_depth_m_; }
    /// Real part of the impedance, 1 / (sigma * skin depth).
    double resistance_ohm() const { return resistance_ohm_; }
    Complex ohm() const { return {resistance_ohm_, resistance_ohm_}; }
    /// @in cos_incidence in (0, 1], in air
    Reflection reflection(double cos_incidence) const;

  private:
    double skin_depth_m_;
    double resistance_ohm_;
};

/// Depth at which the field of a wave that entered any lossy medium head-on has fallen to 1/e;
/// infinite without losses.
double penetration_depth_m(const Electrics& medium, double frequency_hz);

}  // namespace specula
