#pragma once

#include "sim/population.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

/// How gain and leakage move while a session is recorded: in straight lines, the whole change from
/// the first frame to the last, none in the middle.
class SessionDrift {
  public:
    /// Draws the changes of one session.
    SessionDrift(const SessionLaw& law, std::size_t n_rx, Stream& stream);

    /// @in  share  of the session that has passed, 0 to 1
    double gain_db(double share) const { return gain_db_ * (share - 0.5); }
    /// Factor on the leakage at each RX.
    std::vector<Complex> board_factor(double share) const;

  private:
    double gain_db_;
    std::vector<double> leakage_db_;   ///< (rx)
    std::vector<double> leakage_rad_;  ///< (rx)
};

}  // namespace specula
