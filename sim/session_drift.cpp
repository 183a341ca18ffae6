#include "sim/session_drift.hpp"

#include <cmath>

namespace specula {

SessionDrift::SessionDrift(const SessionLaw& law, std::size_t n_rx, Stream& stream)
    : gain_db_(law.gain_drift_db.sample(stream)) {
    for (std::size_t rx = 0; rx < n_rx; ++rx) {
        leakage_db_.push_back(law.leakage_drift_db.sample(stream));
        leakage_rad_.push_back(law.leakage_drift_rad.sample(stream));
    }
}

std::vector<Complex> SessionDrift::board_factor(double share) const {
    std::vector<Complex> factors;
    for (std::size_t rx = 0; rx < leakage_db_.size(); ++rx)
        factors.push_back(std::polar(std::pow(10.0, leakage_db_[rx] * (share - 0.5) / 20.0),
                                     -leakage_rad_[rx] * (share - 0.5)));
    return factors;
}

}  // namespace specula
