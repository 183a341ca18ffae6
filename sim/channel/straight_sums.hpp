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
/// again only when one comes that swings faster over angle than all before it.
/// @eq PHYSICS.md#moments
class StraightSums {
  public:
    /// Borrows the route.
    StraightSums(const RouteScatter& scatter, const FrequencyComb& comb);

    /// Adds the route with its body of this material. False, and nothing is added, where no short
    /// series describes the material or the paths are too far apart for few frequencies.
    bool add(const Reflector& reflector, Channel& channel);

  private:
    /// The coefficients at the comb's frequencies, (frequency, polynomial).
    struct Series {
        AngularSeries of;
        int n_polynomials = 0;  ///< 0: no short series describes the material
    };
    Series series_of(const Reflector& reflector) const;
    void make_carrier();
    void sum_at_least(int n_polynomials);
    std::vector<double> on_comb(const Moments& moments) const;

    const RouteScatter& scatter_;
    FrequencyComb comb_;
    bool is_empty_;
    MomentGrid grid_;                 ///< as many frequencies as the paths need
    std::vector<double> comb_hz_;     ///< all frequencies of the comb
    std::vector<double> from_nodes_;  ///< (node, frequency of the comb)
    std::vector<Complex> carrier_;    ///< (frequency of the comb)
    std::size_t n_columns_ = 0;       ///< of `moments_`
    /// By RX: (frequency of the comb; real and imaginary part of incident, TE and TM moments)
    std::vector<std::vector<double>> moments_;
};

}  // namespace specula
