#pragma once

#include "scenes/antenna.hpp"
#include "sim/trace/physical_optics.hpp"
#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/thin_points.hpp"

namespace specula {

/// A point of a surface under TX, with what all RX have in common.
struct LitNode {
    Vector3 point_m;
    Vector3 normal;    ///< unit, against the wave
    Vector3 arriving;  ///< unit
    Vector3 tx_field;
    double r1_m;
    double stretch_m2;  ///< area per unit of u and v
    bool at_back;       ///< the wave comes from behind the surface
};

/// TX and what its pattern needs, for many points.
class NodeLighter {
  public:
    explicit NodeLighter(const PlacedAntenna& tx) : tx_(tx), pattern_(tx.pattern, tx.rotation) {}
    LitNode operator()(const SurfacePoint& at) const;

  private:
    const PlacedAntenna& tx_;
    FieldPattern pattern_;
};

/// A lit node and one RX.
struct NodeView {
    double r2_m;
    Vector3 to_rx;  ///< unit
    BounceWeights weights;
};

/// An RX and what its pattern needs, for many nodes.
class NodeViewer {
  public:
    explicit NodeViewer(const PlacedAntenna& rx) : rx_(rx), pattern_(rx.pattern, rx.rotation) {}
    NodeView operator()(const LitNode& node) const;

  private:
    const PlacedAntenna& rx_;
    FieldPattern pattern_;
};

/// The few Chebyshev points of a patch, lit by TX and seen by every RX.
struct ThinNodes {
    std::vector<LitNode> lit;                 ///< (v, u)
    std::vector<std::vector<NodeView>> seen;  ///< (rx, node)
};
ThinNodes thin_nodes(const Surface& surface, const Patch& patch, const PointCount& thin,
                     const AntennaSet& antennas);

/// What the weights of a node are multiplied with, and where its coefficients are asked for.
struct NodeShare {
    double spread;
    double cos_incidence;
};
/// Appends a node to a pair, but for its factor.
void append(const LitNode& node, const NodeView& view, const NodeShare& share, PairScatter& pair);

}  // namespace specula
