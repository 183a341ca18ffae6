#pragma once

#include "sim/signal/dechirp.hpp"

namespace specula {

/// The frequencies of the default chirp.
inline const FrequencyComb test_comb = comb_of(Chirp{});

}  // namespace specula
