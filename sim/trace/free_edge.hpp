#pragma once

#include <vector>

#include "sim/trace/edge_currents.hpp"
#include "sim/trace/target.hpp"

namespace specula {

/// A side of a surface beyond which there is nothing.
struct FreeEdge {
    enum class Side { low_u, high_u, low_v, high_v };
    Surface surface;
    Side side;

    struct Place {
        Vector3 point_m;
        double stretch_m;  ///< length of the edge per unit of t
        EdgeFrame frame;   ///< its normal on the surface's front
    };
    /// @in  t  in (-1, 1) along the edge
    Place at(double t) const;
};

/// The rim of a plate; of a mesh, the sides that belong to one triangle only. Where two faces of a
/// mesh meet at an angle there is a wedge, not an edge.
std::vector<FreeEdge> free_edges(const Body& body);

}  // namespace specula
