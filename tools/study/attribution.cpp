#include "tools/study/attribution.hpp"

#include <algorithm>

#include "classifier/metrics.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

namespace {

/// Which step follows which: the loss is against `before`.
struct Step {
    std::string_view condition, before, title;
};

constexpr Step steps[] = {
    {nominal_condition, "", "Random frames of the training sessions"},
    {rerecorded_condition, nominal_condition, "+ new sessions"},
    {tilt_sensor_condition, rerecorded_condition, "+ sensor tilted 10\u00b0"},
    {tilt_sample_condition, rerecorded_condition, "+ sample tilted 10\u00b0 instead"},
    {height_condition, rerecorded_condition, "+ height off by 10 cm instead"},
    {similar_condition, rerecorded_condition, "+ other samples instead"},
};

const DomainScore* find_score(const std::vector<DomainScore>& scores, std::string_view name) {
    const auto found =
        std::ranges::find_if(scores, [&](const DomainScore& s) { return s.domain == name; });
    return found == scores.end() ? nullptr : &*found;
}

}  // namespace

std::vector<WaterfallStep> waterfall(const StudyContext& context,
                                     const std::vector<DomainScore>& scores) {
    std::vector<WaterfallStep> found;
    for (const Step& step : steps) {
        const DomainScore* score = find_score(scores, step.condition);
        if (score == nullptr) continue;
        WaterfallStep entry{.title = std::string(step.title),
                            .all = score->all,
                            .merged = score->merged,
                            .loss = {}};
        if (const DomainScore* before = find_score(scores, step.before)) {
            std::vector<double> losses;
            for (std::size_t i = 0; i < score->per_world.all.size(); ++i)
                losses.push_back(score->per_world.all[i] - before->per_world.all[i]);
            entry.loss = bootstrap_mean(losses, context.bootstrap());
        }
        found.push_back(std::move(entry));
    }
    return found;
}

}  // namespace specula
