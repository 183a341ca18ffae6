#pragma once

#include "sim/core/document.hpp"

namespace specula {

/// How exactly the field is worked out: [solver] of a scene or an experiment.
struct Solver {
    double accuracy_db = 0.1;  ///< of the sums against the converged integrals, 1e-6 to 3
    int max_bounces = 3;       ///< surfaces a wave may meet, 1 to 4

    /// What becomes of the heights of rough faces: speckle of cells, an explicit height field
    /// (slow, for reference), or the loss of the coherent echo alone.
    enum class Roughness { statistical, height_field, coherent };
    Roughness roughness = Roughness::statistical;
    bool edge_currents = false;  ///< add what free edges of metals send back beyond optics
};

/// Reads [solver] of a file's root table; where there is none, the defaults hold.
Solver read_solver(Section& root);

}  // namespace specula
