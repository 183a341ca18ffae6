#pragma once

#include "sim/channel/straight_sums.hpp"

namespace specula {

/// Channels of one geometry with any number of materials: what a scatter's points have to be asked
/// is asked once, and every further material, thickness, stack or coherent roughness costs its own
/// coefficients only. Gives what channel_of gives, to 1e-6 of the largest value.
///
/// One per thread: it sums again where a material needs more terms than those before it.
/// @eq PHYSICS.md#moments
class MaterialChannels {
  public:
    /// Borrows the scatter.
    MaterialChannels(const Scatter& scatter, const FrequencyComb& comb);

    /// @in  reflectors  (body)
    Channel channel(std::span<const Reflector> reflectors, const ForEach& for_each = one_by_one);

  private:
    const Scatter& scatter_;
    FrequencyComb comb_;
    double reference_path_m_;
    std::vector<StraightSums> straight_;  ///< of the routes without events, in their order
};

}  // namespace specula
