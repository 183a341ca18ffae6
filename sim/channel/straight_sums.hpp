#pragma once

#include <vector>

#include "sim/channel/channel.hpp"
#include "sim/channel/coefficient_table.hpp"
#include "sim/channel/moments.hpp"

namespace specula {

/// What the currents of a route are multiplied with, as an event.
Event currents_of(const Route& route);

/// A route without events, summed once for any number of materials.
///
/// The sums over its points know no material. They are made when the first material comes, and
/// again only when one comes that swings faster over angle or frequency than all before it.
/// @eq PHYSICS.md#moments
class StraightSums {
  public:
    /// Borrows the route.
    StraightSums(const RouteScatter& scatter, const FrequencyComb& comb);

    /// Adds the route with its body of this material. False, and nothing is added, where no short
    /// series describes the material or the paths are too far apart for few frequencies.
    bool add(const Reflector& reflector, Channel& channel);

  private:
    bool add_smooth(const CoefficientTable& table, Channel& channel);
    bool add_swinging(const Reflector& reflector, Channel& channel);
    void sum_at_least(int n_frequencies, int n_polynomials);
    void add_interpolated(const std::vector<Complex>& at_nodes, Channel& channel) const;

    const RouteScatter& scatter_;
    FrequencyComb comb_;
    bool is_empty_;
    int n_for_paths_;  ///< frequencies that the paths alone need
    MomentGrid grid_;
    std::vector<Moments> moments_;    ///< (rx), on the grid
    std::vector<double> nodes_hz_;    ///< of the grid
    std::vector<double> from_nodes_;  ///< (node, frequency of the comb)
    std::vector<Complex> carrier_;    ///< (frequency of the comb)
    double reference_path_m_;
};

}  // namespace specula
