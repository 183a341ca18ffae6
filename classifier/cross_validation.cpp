#include "classifier/cross_validation.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "classifier/nearest_neighbours.hpp"
#include "classifier/predict.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"

namespace specula {

namespace {

std::size_t n_distinct(std::span<const std::int32_t> group) {
    return std::set<std::int32_t>(group.begin(), group.end()).size();
}

template <typename T>
void shuffle(std::vector<T>& values, Stream& stream) {
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1], values[stream.below(static_cast<std::uint32_t>(i))]);
}

/// The dataset's name of what is left out.
const char* leave_out_name(LeaveOut what) {
    switch (what) {
        case LeaveOut::frame:
            return "frame";
        case LeaveOut::session:
            return "session";
        case LeaveOut::view:
            return "view";
        case LeaveOut::sample:
            return "sample";
    }
    return "frame";
}

/// What is learnt from the one table says about the other.
Predictions answer(const FeatureTable& training, const FeatureTable& judged,
                   const CrossValidation& how, const StreamKey& key) {
    if (how.neighbours == 0) return predict(fold(train(training, how.options, key)), judged);
    const auto most = static_cast<int>(std::min<std::size_t>(training.size(), 1u << 20));
    return NearestNeighbours(training, std::min(how.neighbours, most)).predict(judged);
}

}  // namespace

std::vector<std::int32_t> groups_of(const Dataset& dataset, LeaveOut what) {
    if (what == LeaveOut::view && !dataset.has_views)
        throw InputError("view: the dataset tells no views apart; leave out sessions or samples");
    std::vector<std::int32_t> group;
    for (const Truth& truth : dataset.truth)
        group.push_back(what == LeaveOut::frame     ? static_cast<std::int32_t>(group.size())
                        : what == LeaveOut::session ? truth.session
                        : what == LeaveOut::view    ? truth.view
                                                    : truth.sample);
    if (n_distinct(group) < 2)
        throw InputError(
            format("/{0}: all frames have one {0}, {1}: the dataset tells no groups apart; record "
                   "more than one, or say in the import's manifest which frames belong together",
                   leave_out_name(what), group.empty() ? 0 : group.front()));
    return group;
}

void expect_groups_in_classes(const FeatureTable& rows, std::span<const std::int32_t> group,
                              LeaveOut what) {
    SPECULA_EXPECT(group.size() == rows.size());
    std::map<std::uint8_t, std::set<std::int32_t>> groups;
    for (std::size_t i = 0; i < rows.size(); ++i) groups[rows.label[i]].insert(group[i]);
    for (const auto& [label, own] : groups) {
        if (own.size() > 1) continue;
        throw InputError(
            format("/{0}: all frames of class \"{1}\" have one {0}, {2}: left out, nothing of the "
                   "class is left to learn from; record two or more of each class, or say in the "
                   "import's manifest which frames belong together",
                   leave_out_name(what), rows.class_names.at(label), *own.begin()));
    }
}

std::vector<int> deal_folds(const FeatureTable& rows, std::span<const std::int32_t> group,
                            int n_folds) {
    SPECULA_EXPECT(group.size() == rows.size() && n_folds >= 2);
    std::vector<std::pair<std::uint8_t, std::int32_t>> groups;  // (class of the first, number)
    std::set<std::int32_t> seen;
    for (std::size_t i = 0; i < group.size(); ++i)
        if (seen.insert(group[i]).second) groups.emplace_back(rows.label[i], group[i]);
    if (groups.size() == rows.size()) {  // single frames: their order would show in the folds
        Stream stream({.seed = 1, .purpose = "folds of single frames"});
        shuffle(groups, stream);
    } else {
        std::ranges::sort(groups);
    }
    std::map<std::int32_t, int> fold_of;
    for (std::size_t i = 0; i < groups.size(); ++i)
        fold_of[groups[i].second] = static_cast<int>(i % static_cast<std::size_t>(n_folds));
    std::vector<int> fold;
    for (const std::int32_t number : group) fold.push_back(fold_of[number]);
    return fold;
}

FeatureTable with_shuffled_classes(const FeatureTable& rows, std::span<const std::int32_t> sample,
                                   const StreamKey& key) {
    std::map<std::int32_t, std::size_t> place;
    std::vector<std::uint8_t> classes;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (place.emplace(sample[i], classes.size()).second) classes.push_back(rows.label[i]);
    Stream stream(key);
    shuffle(classes, stream);
    FeatureTable shuffled = rows;
    for (std::size_t i = 0; i < rows.size(); ++i) shuffled.label[i] = classes[place[sample[i]]];
    return shuffled;
}

std::vector<std::uint8_t> cross_predict(const FeatureTable& rows, const CrossValidation& how,
                                        std::atomic<std::size_t>* done) {
    std::vector<std::uint8_t> predicted(rows.size());
    const auto run_fold = [&](std::size_t held_out) {
        std::vector<std::size_t> training, judged;
        for (std::size_t i = 0; i < rows.size(); ++i)
            (how.fold[i] == static_cast<int>(held_out) ? judged : training).push_back(i);
        if (judged.empty()) return;
        const Predictions answers =
            answer(select_rows(rows, training), select_rows(rows, judged), how,
                   {.seed = how.seed,
                    .purpose = "cross-validation",
                    .item = static_cast<std::uint32_t>(held_out)});
        for (std::size_t k = 0; k < judged.size(); ++k) predicted[judged[k]] = answers.label[k];
    };
    for_each_index(static_cast<std::size_t>(how.n_folds), how.threads, run_fold, done);
    return predicted;
}

double accuracy(std::span<const std::uint8_t> truth, std::span<const std::uint8_t> predicted) {
    SPECULA_EXPECT(!truth.empty() && truth.size() == predicted.size());
    std::size_t right = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) right += truth[i] == predicted[i];
    return static_cast<double>(right) / static_cast<double>(truth.size());
}

}  // namespace specula
