#pragma once

#include "tools/report/study_summary.hpp"
#include "tools/study/stage_clock.hpp"
#include "tools/study/study_context.hpp"

namespace specula {

/// The classifier as the paper has it, one per world and repeat.
struct Baseline {
    RandomSplits splits;
    std::vector<Model> models;                        ///< (world), of the first repeat
    std::vector<std::vector<Model>> repeats;          ///< (further repeat, world)
    std::vector<std::string> domains;                 ///< nominal first
    std::vector<WorldRows> rows;                      ///< (domain)
    std::vector<std::vector<WorldOutcome>> outcomes;  ///< (domain, world), of the first repeat
    std::vector<DomainScore> scores;                  ///< (domain), mean over repeats
};

Baseline train_baseline(const StudyContext& context, const Recording& training);

/// Judges the baseline on held-back frames and every condition; fills the summary's conditions, and
/// its parts: single heights and tilts of conditions that have several.
void judge_conditions(const StudyContext& context, const std::vector<Recording>& recordings,
                      Baseline& baseline, StudySummary& summary);

struct StudyState {
    const StudyContext& context;
    const std::vector<Recording>& recordings;  ///< training first
    const Baseline& baseline;
};

/// Whatever the extent asks for beyond the conditions: checks, attribution, remedies, the grid.
void extend_study(const StudyState& state, StageClock& clock, StudySummary& summary);

}  // namespace specula
