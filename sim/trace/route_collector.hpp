#pragma once

#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/walk.hpp"

namespace specula {

/// A point of the quadrature: where, how much area, and its front side.
struct WeightedPoint {
    Vector3 point_m;
    Vector3 normal;  ///< unit
    double area_m2;
};

/// Sorts points into routes and works out their weights.
class RouteCollector {
  public:
    RouteCollector(const Target& target, const AntennaSet& antennas)
        : target_(target), antennas_(antennas) {
        scatter_.n_rx = static_cast<int>(antennas.rx.size());
    }

    void add(const WeightedPoint& point, int body, const Walk& walk, const Vector3& source_m,
             std::size_t rx);
    Scatter take() { return std::move(scatter_); }

  private:
    PairScatter& pair_of(const Route& route, std::size_t rx);

    const Target& target_;
    const AntennaSet& antennas_;
    Scatter scatter_;
};

}  // namespace specula
