#pragma once

#include <functional>

#include "sim/trace/route_collector.hpp"
#include "sim/trace/trace_settings.hpp"

namespace specula {

/// Straight ways over a face of many small surfaces, a mesh: rays are cast for the points of many
/// surfaces at once, since a small triangle's own would not fill a packet.
///
/// Gives what tracing surface by surface gives; patches that need cutting are handed back.
class ManySurfaces {
  public:
    /// Traces one patch by itself.
    using Alone = std::function<void(const Surface&, const Patch&)>;
    /// Borrows all of them.
    ManySurfaces(const Target& target, const AntennaSet& antennas, const TraceSettings& settings,
                 RouteCollector& routes)
        : target_(target), antennas_(antennas), settings_(settings), routes_(routes) {}

    struct Task {
        int face;
        std::size_t rx;
    };
    void add(const Task& task, const Alone& alone);

    /// From as many surfaces on it pays.
    static constexpr std::size_t fewest = 64;

  private:
    struct Piece;
    struct Straight;
    std::vector<Straight> straight_ways(const Task& task,
                                        const std::vector<WeightedPoint>& points) const;
    bool is_settled(const Piece& piece, const std::vector<Straight>& ways) const;
    double wavelength_m() const;

    const Target& target_;
    const AntennaSet& antennas_;
    const TraceSettings& settings_;
    RouteCollector& routes_;
};

}  // namespace specula
