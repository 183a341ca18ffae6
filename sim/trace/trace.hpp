#pragma once

#include "scenes/radar.hpp"
#include "scenes/sample.hpp"
#include "sim/trace/geometry.hpp"
#include "sim/trace/scatter.hpp"

namespace specula {

/// A plate in its place before a radar in its place.
struct PlateView {
    Plate plate;
    Placement plate_placement;
    Placement radar_placement;
};

/// The face of a plate as the radar sees it, ready to be summed at any frequency up to
/// `highest_hz`.
///
/// The face is covered by Gauss-Legendre points on the true (also bowed) surface, as many as the
/// phase of exp(-jk path) needs; where the antennas see only part of a patch, it is cut smaller.
/// @eq PHYSICS.md#surface-integral, #quadrature
Scatter trace(const PlateView& view, const Radar& radar, const Geometry& geometry,
              double highest_hz);

}  // namespace specula
