#pragma once

#include <optional>

#include "sim/trace/target.hpp"
#include "sim/trace/thin_nodes.hpp"
#include "sim/trace/trace_settings.hpp"

namespace specula {

/// A plate by itself that all antennas see one whole side of, by antennas whose patterns are smooth
/// over it, and over a band: few points do in place of many. The phase at the middle of the band is
/// summed into complex weights, which stand in the points' `factor`; good over the band of the
/// settings only.
/// @eq PHYSICS.md#thinned-quadrature
class ThinPlate {
  public:
    /// Nothing where a plate is not alone or not seen so. Refers to target and antennas.
    static std::optional<ThinPlate> of(const Target& target, const AntennaSet& antennas,
                                       const TraceSettings& settings);

    /// What `trace` says of it. Nothing where the band is too wide for few points to save anything.
    std::optional<Scatter> echo();

    const PlateSurface& surface() const { return *plate_; }
    const AntennaSet& antennas() const { return *antennas_; }
    const Detail& detail() const { return detail_; }
    /// For the plate as one patch.
    const ThinCounts& counts() const { return counts_; }
    /// Likewise; made for the first who asks, as the plate's echo and its speckle need the same.
    const ThinNodes& nodes();

  private:
    ThinPlate(const PlateSurface& plate, bool is_opaque, const AntennaSet& antennas,
              const TraceSettings& settings);
    ThinCounts counts_of(const Patch& patch) const;
    /// False where few points are not worth while.
    bool add(const Patch& patch, RouteScatter& route) const;
    bool add_halves(const Patch& patch, const PointCount& dense, RouteScatter& route) const;
    void add_points(const Patch& patch, const ThinCounts& counts, const ThinNodes& nodes,
                    RouteScatter& route) const;

    const PlateSurface* plate_;
    bool is_opaque_;
    const AntennaSet* antennas_;
    std::vector<Vector3> rx_m_;
    double accuracy_db_;
    Detail detail_;
    ThinCounts counts_;
    std::optional<ThinNodes> nodes_;
};

/// Do all antennas see the plate's front, or all of them its back, and does no part of the plate
/// stand before another? True for flat and bowed ones but at grazing angles.
bool is_seen_whole(const PlateSurface& plate, const AntennaSet& antennas);

}  // namespace specula
