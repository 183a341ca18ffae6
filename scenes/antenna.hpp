#pragma once

#include <string_view>
#include <variant>

#include "scenes/antenna_table.hpp"
#include "scenes/vector3.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// The same gain everywhere: for comparison with closed forms.
struct IsotropicPattern {
    static constexpr std::string_view kind = "isotropic";
    double gain_dbi = 0.0;

    double gain(const Vector3& direction) const;
    static IsotropicPattern read(Section& section);
};

/// A patch: G0 cos^a(azimuth) cos^e(elevation) in front, nothing behind. Azimuth is
/// atan2(d.x, d.boresight), elevation asin(d.y); the exponents follow from the half widths at -6
/// dB.
struct PatchPattern {
    static constexpr std::string_view kind = "patch";
    double gain_dbi = 5.5;
    double half_width_azimuth_rad = 1.0471975511965976;
    double half_width_elevation_rad = 0.6108652381980153;

    double gain(const Vector3& direction) const;
    static PatchPattern read(Section& section);
};

using Pattern = std::variant<IsotropicPattern, PatchPattern, TablePattern>;

/// Linear gain towards a unit direction in the radar's own frame (boresight -z).
double gain_towards(const Pattern& pattern, const Vector3& direction);

/// The power that a pattern radiates over the power it is fed: the mean of its gain over all
/// directions, by a midpoint rule of two degrees. More than 1 is no passive antenna.
double radiated_share(const Pattern& pattern);
/// With room for the rule and for rounded datasheets.
inline constexpr double largest_radiated_share = 1.01;

/// Effective polarisation of an antenna polarised along +y of the radar's frame: the transverse
/// part of y, normalised, times sqrt(gain). Its squared length is the gain.
/// @in  direction  unit, leaving the antenna, radar frame
Vector3 field_pattern(const Pattern& pattern, const Vector3& direction);

/// field_pattern of an antenna turned in the scene, for many directions: what does not depend on
/// them is worked out once.
class FieldPattern {
  public:
    /// Borrows the pattern.
    /// @in  rotation  from the antenna's own frame to the scene's
    FieldPattern(const Pattern& pattern, const Rotation& rotation);
    /// Both in the scene's frame.
    Vector3 operator()(const Vector3& direction) const;

  private:
    double root_gain(const Vector3& own_direction) const;

    const Pattern& pattern_;
    Vector3 x_, y_, z_;       ///< axes of the antenna
    double root_peak_ = 1.0;  ///< of a patch, like its exponents
    double azimuth_exponent_ = 0.0;
    double elevation_exponent_ = 0.0;
};

}  // namespace specula
