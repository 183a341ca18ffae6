#pragma once

#include <optional>

#include "classifier/augmentation.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Bins below hold leakage and stay where they are when the scene moves.
inline constexpr std::size_t first_moved_bin = 3;

struct Tone {
    double amplitude_lsb;
    double bin;
};

struct Move {
    double bins;       ///< farther away
    double level;      ///< factor of amplitudes, IF high-pass left out
    double phase_rad;  ///< by which the carrier turns
    bool keeps_level;  ///< the IF high-pass is then left out too
};

/// One step as drawn for one copy of one frame. The same place gives the same draw, whatever else
/// is drawn.
class StepDraw {
  public:
    struct Place {
        const StreamKey& key;
        std::size_t step = 0;
    };
    StepDraw(const AugmentStep& step, const RadarView& radar, const Place& place);

    /// In the unit of unit_of.
    double value() const { return value_; }
    /// For what else the step draws.
    Stream& stream() { return stream_; }
    template <typename Step>
    bool is() const {
        return std::holds_alternative<Step>(step_);
    }
    /// What leakage and clutter add. Throws InputError where the range bin is not known.
    std::optional<Tone> tone();
    /// How shift and range move a sample that is `range_m` away. Throws InputError where the range
    /// bin is not known, and where the sample would come to lie among leakage or beyond the chirp's
    /// farthest range.
    std::optional<Move> move(double range_m);

  private:
    void need_bin() const;

    const AugmentStep& step_;
    const RadarView& radar_;
    Stream stream_;
    double value_;
};

/// Whether a step asks how far away the sample is.
bool needs_range(const Augmentation& how);

}  // namespace specula
