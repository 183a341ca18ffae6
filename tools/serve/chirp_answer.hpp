#pragma once

#include "tools/serve/page_bench.hpp"
#include "tools/serve/rung_training.hpp"

namespace specula {

/// All that the page shows of one chirp: codes, range profile, descriptor, what every model says,
/// where the mirror's foot lies, what the session drew, the reflection over the band, warnings.
FloatJson chirp_answer(const PageChirp& chirp, const RungSet& models, const Experiment& experiment,
                       const Library& materials);

/// First chirp of the frame, a row per sample, a column per RX.
std::string chirp_csv(const PageChirp& chirp);

}  // namespace specula
