#pragma once

#include <optional>

#include "sim/core/random.hpp"
#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"
#include "sim/trace/thin_plate.hpp"

namespace specula {

/// One rough face of a body's stack.
struct RoughLayer {
    int body = 0;
    int face = 0;                 ///< of the body's stack, from the top
    double correlation_m = 1e-3;  ///< of its heights
};

/// The diffuse echo of a rough face as a route of its own: cells of the surface, each a point with
/// an amplitude of mean square 1 that scatters by its stack's `diffuse_reflection`.
///
/// Cells lie fixed on the body, no smaller than the correlation length, so that their amplitudes
/// are independent, and with side^2 far below wavelength times distance, so that one phase does for
/// a cell. Their places do not depend on where body and radar are. Cells that TX or RX do not see
/// have zero weight; every pair has all cells, in the same order.
/// @eq PHYSICS.md#speckle
/// Limit: straight waves only, no mirrors or sheets on the way; directions to TX and RX within
/// about 20 degrees of each other; nearer to grazing than 70 degrees the level is that at 70.
RouteScatter diffuse_cells(const Target& target, const AntennaSet& antennas,
                           const RoughLayer& layer);

/// Gives every cell its complex Gaussian amplitude. They belong to the piece: moving it turns the
/// cells against each other, which is what decorrelates speckle; standing still does not.
void draw_speckle(RouteScatter& cells, Stream& piece);

/// The same cells, drawn, of a plate by itself: the phase at the middle of the band and the cells'
/// amplitudes are summed into few points. Nothing where that is not possible or saves nothing; the
/// stream is then as it was.
std::optional<RouteScatter> drawn_thin_cells(ThinPlate& plate, const RoughLayer& layer,
                                             Stream& piece);

/// The smallest side of a cell.
inline constexpr double smallest_cell_m = 6e-3;

}  // namespace specula
