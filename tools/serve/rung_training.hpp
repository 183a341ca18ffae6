#pragma once

#include "sim/dataset/dataset.hpp"
#include "tools/serve/rung.hpp"
#include "tools/study/experiment.hpp"

namespace specula {

/// The piece of a class that the models learnt from.
struct TrainingPiece {
    std::string name;  ///< class, and material
    double thickness_mm = 0.0;
    double bow_mm = 0.0;
    double roughness_um = 0.0;
    double correlation_mm = 0.0;
};

/// All models of the page and what they learnt from.
struct RungSet {
    std::vector<Rung> rungs;            ///< in the order of `rung_recipes`
    std::vector<TrainingPiece> pieces;  ///< (class)
};

/// How many heights from 33 to 57 cm, and tilts to 12 degrees either way, are learnt from: the
/// paper's shifts lie well inside. Heights lie 0.6 of a bin apart, so that no place between bins is
/// left out.
struct GeometryGrid {
    int heights = 11;
    int tilts = 7;
};

/// Simulates the recordings, on all processors, and trains every rung on them; some seconds, with
/// progress on standard error.
RungSet train_rungs(const Experiment& experiment, const Library& materials, int threads,
                    const GeometryGrid& grid = {});

/// What of the experiment's piece of a class is drawn, rounded to what the page's fields show.
std::vector<TrainingPiece> training_pieces(const Dataset& recorded);

}  // namespace specula
