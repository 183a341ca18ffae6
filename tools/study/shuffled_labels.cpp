#include "tools/study/shuffled_labels.hpp"

#include "classifier/cross_validation.hpp"
#include "classifier/metrics.hpp"
#include "sim/parallel.hpp"

namespace specula {

namespace {

constexpr int session_folds = 4;

}  // namespace

FeatureTable with_shuffled_frames(const FeatureTable& rows, const StreamKey& key) {
    FeatureTable shuffled = rows;
    Stream stream(key);
    for (std::size_t i = shuffled.label.size(); i > 1; --i)
        std::swap(shuffled.label[i - 1],
                  shuffled.label[stream.below(static_cast<std::uint32_t>(i))]);
    return shuffled;
}

WorldScores leave_sessions_out(const WorldRows& rows, const StudyContext& context) {
    WorldScores scores;
    scores.all.resize(rows.size());
    scores.merged.resize(rows.size());
    const auto judge = [&](std::size_t world) {
        const FeatureTable& own = rows[world];
        TrainOptions options = context.experiment.classifier;
        options.epochs = context.extent.epochs;
        const auto predicted =
            cross_predict(own, {.fold = deal_folds(own, own.session, session_folds),
                                .n_folds = session_folds,
                                .options = options,
                                .seed = context.run.seed,
                                .threads = 1});
        const Confusion confusion = confusion_of(own.label, predicted, own.class_names.size());
        scores.all[world] = macro_f1(confusion);
        scores.merged[world] = macro_f1(merge_classes(confusion, context.merged));
    };
    for_each_index(rows.size(), context.run.threads, judge);
    return scores;
}

WorldRows with_shuffled_sessions(const WorldRows& rows, const StudyContext& context) {
    WorldRows shuffled;
    for (std::size_t world = 0; world < rows.size(); ++world)
        shuffled.push_back(with_shuffled_classes(rows[world], rows[world].session,
                                                 {.seed = context.run.seed,
                                                  .purpose = "shuffled sessions",
                                                  .world = static_cast<std::uint32_t>(world)}));
    return shuffled;
}

}  // namespace specula
