#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// The training recordings and every condition, described for the rungs.
struct LadderInput {
    const Recording& training;
    const std::vector<const Recording*>& conditions;
};

/// Rows that one rung learns from and is judged on.
struct RungRows {
    WorldRows training;
    std::vector<std::string> domains;  ///< nominal first
    std::vector<WorldRows> judged;     ///< (domain)
};

/// The worlds that decide which rung is recommended: every other one, from the first on.
std::vector<std::size_t> choosing_worlds(std::size_t n_worlds);

/// Marks the rung whose worst condition, classes merged, is best over these worlds; of equals
/// within half a point the cheapest.
void recommend(std::vector<LadderRung>& rungs, const std::vector<std::size_t>& worlds);

/// Compares the remedies: the same worlds, judged frames, number of rows and steps for each;
/// nothing is selected, the network of the last epoch counts. Records the training sets.
///
/// What it is good for is said of the worlds that had no say in recommending it.
class Ladder {
  public:
    Ladder(const StudyContext& context, const LadderInput& input);

    std::vector<LadderRung> run() const;
    /// One model per world of a rung, first repeat.
    std::vector<Model> models_of(const RungPlan& rung) const;

  private:
    void record_sets();
    void record_motion();
    const FeatureTable& table_of(const RungPlan& rung, const Recording& recording) const;
    RungRows rows_of(const RungPlan& rung) const;
    void confirm(std::vector<LadderRung>& rungs) const;
    TrialTraining training_of(const RungPlan& rung, int repeat) const;

    const StudyContext& context_;
    const LadderInput& input_;
    std::map<std::string, PassingRecording> sets_;    ///< by name
    std::map<std::string, PassingRecording> motion_;  ///< by condition, where a rung asks for it
};

/// What a trained rung costs on the chip beyond the range profile.
RungCost cost_of(const RungPlan& rung, const Model& model, int n_rows);

}  // namespace specula
