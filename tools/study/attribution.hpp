#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// From random frames over new sessions to tilts, heights and other samples: what each step costs,
/// paired by worlds. Steps whose condition the experiment lacks are left out.
std::vector<WaterfallStep> waterfall(const StudyContext& context,
                                     const std::vector<DomainScore>& scores);

/// Rows of one condition, and what each world's model made of them.
struct JudgedDomain {
    std::string name{};
    const WorldRows& rows;
    const std::vector<WorldOutcome>& outcomes;  ///< (world)
};

/// What the baseline's models stand on.
struct MonitoredModels {
    const std::vector<Model>& models;  ///< (world), with their prototypes
    const WorldRows& training;
};

/// Detectors, fallback, confidence and drift of every domain; the first is nominal, and frames of
/// the nominal recording made anew are what detectors must not flag.
void judge_monitors(const StudyContext& context, const MonitoredModels& baseline,
                    const std::vector<JudgedDomain>& domains, StudyResults& results);

}  // namespace specula
