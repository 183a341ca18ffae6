#pragma once

#include "scenes/antenna.hpp"
#include "scenes/plate.hpp"
#include "scenes/pose.hpp"
#include "sim/channel/channel.hpp"
#include "tools/validate/fields.hpp"

namespace specula {

/// A square plate below one TX and one RX that look straight down, as cases describe it.
struct PlateUnderRadar {
    Plate plate;
    Pose pose;
    Pattern tx_pattern = IsotropicPattern{};
    Pattern rx_pattern = IsotropicPattern{};
    Vector3 tx_m = Vector3::Zero();  ///< beside the radar's axis
    Vector3 rx_m = Vector3::Zero();
    Reflector reflector;

    /// What the simulator sees of it, good up to a frequency.
    Scatter scatter(double highest_hz) const;
    PlateUnderRadar with_swapped_antennas() const;
    /// |h| in dB of an infinite mirror as far below, with the gains along the axis.
    double image_db(double frequency_hz) const;
};

/// `L_m`, `H_m`; `tilt_deg` about `tilt_axis` ("x" or "y", words may follow) through the plate's
/// centre; `plate_centre_xy_m`; `antenna`, or `ant_tx` and `ant_rx`; `tx_xy_m`, `rx_xy_m`;
/// `sag_at_edge_midpoint_m`. What is not given is none of it: level, centred, isotropic,
/// co-located, flat. The plate is of metal.
/// @in  highest_hz  to refuse sizes beyond the machine
PlateUnderRadar plate_under_radar(const Fields& inp, double highest_hz);

/// A perfect conductor.
Reflector perfect_reflector();

/// A slab in air or on a backing, of a permittivity that does not depend on frequency: `eps`,
/// `d_m`, `backing` behind a prefix.
Reflector slab_reflector(const Fields& inp, const std::string& prefix = "");

/// Error of traced sums that cases are held against, in dB: far below any tolerance.
inline constexpr double validation_accuracy_db = 1e-6;

}  // namespace specula
