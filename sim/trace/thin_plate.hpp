#pragma once

#include <optional>

#include "sim/trace/quadrature.hpp"
#include "sim/trace/trace.hpp"

namespace specula {

/// What trace does for a plate by itself that all antennas see one whole side of, with few points
/// in place of many: the phase at the middle of the band is summed into complex weights, which
/// stand in the points' `weight` and `phase_rad`. Good over the band of the settings only.
///
/// Nothing where a plate is not alone or not seen so, or where the band is too wide for this to
/// save anything.
/// @eq PHYSICS.md#thinned-quadrature
std::optional<Scatter> trace_thin_plate(const Target& target, const AntennaSet& antennas,
                                        const TraceSettings& settings);

/// Do all antennas see the plate's front, or all of them its back, and does no part of the plate
/// stand before another? True for flat and bowed ones but at grazing angles.
bool is_seen_whole(const PlateSurface& plate, const AntennaSet& antennas);

/// The plate that may be thinned: alone, seen whole, by antennas whose patterns are smooth over it,
/// and over a band; else nullptr.
const PlateSurface* thinnable_plate(const Target& target, const AntennaSet& antennas,
                                    const TraceSettings& settings);

/// What turns the integrand over the band of the settings.
Detail detail_of(const TraceSettings& settings);

}  // namespace specula
