#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// A classifier that stands in the grid: what it sees, and one model per world.
struct GridEntrant {
    std::string name;
    std::string kind;           ///< of its features (RungPlan::kind); empty: the experiment's own
    std::vector<Model> models;  ///< (world); as many as are to be judged
};

/// Macro-F1 over heights, tilts and the receiver's severities, of every entrant. The known samples,
/// in sessions of their own; each world is judged by its own model.
SeverityGrid severity_grid(const StudyContext& context, const std::vector<GridEntrant>& entrants);

}  // namespace specula
