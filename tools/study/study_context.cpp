#include "tools/study/study_context.hpp"

#include "classifier/metrics.hpp"
#include "tools/study/judgement.hpp"

namespace specula {

DomainScore StudyContext::score(const std::string& domain, const WorldScores& scores) const {
    return {.domain = domain,
            .all = bootstrap_mean(scores.all, bootstrap()),
            .merged = bootstrap_mean(scores.merged, bootstrap()),
            .per_world = scores};
}

RandomSplits random_splits(const FeatureTable& rows, const StudyContext& context, int worlds) {
    RandomSplits splits;
    for (int world = 0; world < worlds; ++world) {
        Split split =
            split_world(rows, world, context.experiment.validation_share, context.run.seed);
        splits.training.push_back(std::move(split.training));
        splits.validation.push_back(std::move(split.validation));
    }
    return splits;
}

}  // namespace specula
