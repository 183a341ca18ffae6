#pragma once

#include "sim/adc/adc_frame.hpp"
#include "sim/dataset/dataset.hpp"
#include "tools/serve/requested_scene.hpp"
#include "tools/study/experiment.hpp"

namespace specula {

/// The bench of the page: the rooms, boards and laws of the paper's experiment in its first world,
/// with pieces of exactly the library's permittivity, as scene files have it too.
Experiment page_experiment(const Catalogue& catalogue);

/// A chirp as the board gave it, and all that made it.
struct PageChirp {
    Scene scene;
    AdcFrame frame;
    Truth truth;
    bool is_weak = false;  ///< PHYSICS.md#limits: 15 dB below a wide sheet's echo
};

/// Simulates what a request asks for.
///
/// Session 0 is what `specula simulate` makes of the scene file with the frame's number as seed, by
/// the bit. Any other session is drawn, placed and recorded as the experiment's are: 1 to the
/// number of its training sessions are those very sessions where nothing else was changed.
PageChirp simulate_request(const SceneRequest& request, const Experiment& experiment,
                           const Catalogue& catalogue, const KnownNames& known);

/// The chirp as a dataset of one frame.
Dataset dataset_of(const PageChirp& chirp, const SceneRequest& request,
                   const std::string& scene_text);

}  // namespace specula
