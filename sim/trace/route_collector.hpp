#pragma once

#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/walk.hpp"
#include "sim/trace/weighted_points.hpp"

namespace specula {

/// Sorts points into routes and works out their weights.
class RouteCollector {
  public:
    RouteCollector(const Target& target, const AntennaSet& antennas)
        : target_(target),
          antennas_(antennas),
          tx_pattern_(antennas.tx.pattern, antennas.tx.rotation) {
        scatter_.n_rx = static_cast<int>(antennas.rx.size());
        for (const PlacedAntenna& rx : antennas.rx)
            rx_patterns_.emplace_back(rx.pattern, rx.rotation);
    }

    /// A point that the wave reaches and leaves straight.
    struct StraightWay {
        Vector3 arriving;  ///< unit
        Vector3 normal;    ///< unit, against the wave
        bool from_behind = false;
    };
    void add_straight(const WeightedPoint& point, int body, const StraightWay& way, std::size_t rx);

    void add(const WeightedPoint& point, int body, const Walk& walk, const Vector3& source_m,
             std::size_t rx);
    Scatter take() { return std::move(scatter_); }

  private:
    PairScatter& pair_of(const Route& route, std::size_t rx);

    const Target& target_;
    const AntennaSet& antennas_;
    FieldPattern tx_pattern_;
    std::vector<FieldPattern> rx_patterns_;
    Scatter scatter_;
};

}  // namespace specula
