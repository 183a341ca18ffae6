#include "sim/trace/thin_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace specula {

LitNode NodeLighter::operator()(const SurfacePoint& at) const {
    const Vector3 area_normal = at.area_normal();
    const Vector3 from_tx = at.point_m - tx_.position_m;
    LitNode node{.point_m = at.point_m,
                 .normal = area_normal.normalized(),
                 .arriving = from_tx.normalized(),
                 .tx_field = Vector3::Zero(),
                 .r1_m = from_tx.norm(),
                 .stretch_m2 = area_normal.norm(),
                 .at_back = false};
    node.at_back = node.arriving.dot(node.normal) > 0.0;
    if (node.at_back) node.normal = -node.normal;
    node.tx_field = pattern_(node.arriving);
    return node;
}

NodeView NodeViewer::operator()(const LitNode& node) const {
    const Vector3 to_rx = rx_.position_m - node.point_m;
    NodeView view{.r2_m = to_rx.norm(), .to_rx = {}, .weights = {}};
    view.to_rx = to_rx / view.r2_m;
    view.weights = bounce_weights({.to_point = node.arriving,
                                   .to_rx = view.to_rx,
                                   .normal = node.normal,
                                   .tx_field = node.tx_field,
                                   .rx_field = pattern_(-view.to_rx)});
    return view;
}

ThinNodes thin_nodes(const Surface& surface, const Patch& patch, const PointCount& thin,
                     const AntennaSet& antennas) {
    const std::vector<double> along_u = ChebyshevGrid{patch.u[0], patch.u[1], thin.u}.nodes();
    const NodeLighter lit_by(antennas.tx);
    ThinNodes nodes;
    nodes.lit.reserve(static_cast<std::size_t>(thin.u * thin.v));
    for (const double v : ChebyshevGrid{patch.v[0], patch.v[1], thin.v}.nodes())
        for (const double u : along_u) nodes.lit.push_back(lit_by(surface_point(surface, u, v)));
    for (const PlacedAntenna& rx : antennas.rx) {
        const NodeViewer seen_from(rx);
        std::vector<NodeView>& seen = nodes.seen.emplace_back();
        seen.reserve(nodes.lit.size());
        for (const LitNode& node : nodes.lit) seen.push_back(seen_from(node));
    }
    return nodes;
}

void append(const LitNode& node, const NodeView& view, const NodeShare& share, PairScatter& pair) {
    pair.path_m.push_back(node.r1_m + view.r2_m);
    pair.cos_incidence.push_back(std::min(1.0, share.cos_incidence));
    pair.weight[0].push_back(view.weights.incident * share.spread);
    pair.weight[1].push_back(view.weights.te * share.spread);
    pair.weight[2].push_back(view.weights.tm * share.spread);
}

}  // namespace specula
