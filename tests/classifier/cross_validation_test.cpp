#include "classifier/cross_validation.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

/// Pieces of three classes whose feature is the piece and not the class: nothing to learn about
/// classes, everything about pieces.
FeatureTable pieces_only(int n_pieces, int n_frames, std::vector<std::int32_t>& piece) {
    Stream stream({.seed = 4, .purpose = "pieces"});
    FeatureTable rows;
    rows.extractor = "columns";
    rows.n_features = 2;
    rows.class_names = {"a", "b", "c"};
    for (int p = 0; p < n_pieces; ++p) {
        const double x = stream.normal(), y = stream.normal();
        for (int i = 0; i < n_frames; ++i) {
            rows.features.push_back(static_cast<float>(x + 0.01 * stream.normal()));
            rows.features.push_back(static_cast<float>(y + 0.01 * stream.normal()));
            rows.label.push_back(static_cast<std::uint8_t>(p % 3));
            rows.world.push_back(0);
            rows.session.push_back(p);
            piece.push_back(p);
        }
    }
    return rows;
}

CrossValidation quick(const FeatureTable& rows, const std::vector<std::int32_t>& group) {
    return {.fold = deal_folds(rows, group, 5),
            .n_folds = 5,
            .options = {.hidden = {16}, .epochs = 60, .batch_size = 32, .learning_rate = 1e-2}};
}

std::vector<std::int32_t> each_alone(std::size_t n) {
    std::vector<std::int32_t> group(n);
    for (std::size_t i = 0; i < n; ++i) group[i] = static_cast<std::int32_t>(i);
    return group;
}

TEST_CASE("no group is on both sides of a fold, and every class is in every fold", "[classifier]") {
    std::vector<std::int32_t> piece;
    const FeatureTable rows = pieces_only(15, 4, piece);
    const auto fold = deal_folds(rows, piece, 5);
    std::map<std::int32_t, std::set<int>> folds_of;
    std::map<int, std::set<std::uint8_t>> classes_of;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        folds_of[piece[i]].insert(fold[i]);
        classes_of[fold[i]].insert(rows.label[i]);
    }
    for (const auto& [group, folds] : folds_of) CHECK(folds.size() == 1);
    CHECK(classes_of.size() == 5);
    for (const auto& [number, classes] : classes_of) CHECK(classes.size() == 3);
}

TEST_CASE("what is only in the pieces is found with frames left out, not with pieces",
          "[classifier]") {
    std::vector<std::int32_t> piece;
    const FeatureTable rows = pieces_only(30, 8, piece);
    const auto leaky = cross_predict(rows, quick(rows, each_alone(rows.size())));
    const auto honest = cross_predict(rows, quick(rows, piece));
    CHECK(accuracy(rows.label, leaky) > 0.6);    // pieces overlap in two dimensions
    CHECK(accuracy(rows.label, honest) < 0.55);  // chance 1/3; 30 pieces: sd 0.09
}

TEST_CASE("shuffled classes stay one per piece, and as many of each", "[classifier]") {
    std::vector<std::int32_t> piece;
    const FeatureTable rows = pieces_only(30, 3, piece);
    const FeatureTable shuffled =
        with_shuffled_classes(rows, piece, {.seed = 1, .purpose = "shuffle"});
    CHECK(shuffled.label != rows.label);
    CHECK(shuffled.features == rows.features);
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (piece[i] == piece[i - 1]) CHECK(shuffled.label[i] == shuffled.label[i - 1]);
    for (std::uint8_t label = 0; label < 3; ++label)
        CHECK(std::ranges::count(shuffled.label, label) == std::ranges::count(rows.label, label));
}

TEST_CASE("a cross-validation does not depend on the threads", "[classifier]") {
    std::vector<std::int32_t> piece;
    const FeatureTable rows = pieces_only(12, 6, piece);
    CrossValidation how = quick(rows, piece);
    how.options.epochs = 3;
    const auto one = cross_predict(rows, how);
    how.threads = 3;
    CHECK(cross_predict(rows, how) == one);
}

TEST_CASE("groups that a dataset does not tell apart are refused", "[classifier]") {
    Dataset dataset;
    dataset.truth.resize(4);
    CHECK(message_of([&] { return groups_of(dataset, LeaveOut::view); }) ==
          "view: the dataset tells no views apart; leave out sessions or samples");
    CHECK(message_of([&] {
              return groups_of(dataset, LeaveOut::session);
          }).rfind("/session: all frames have one session, 0: the dataset tells no groups apart", 0) ==
          0);
    CHECK(groups_of(dataset, LeaveOut::frame) == std::vector<std::int32_t>{0, 1, 2, 3});
    dataset.truth[2].sample = 5;
    CHECK(groups_of(dataset, LeaveOut::sample) == std::vector<std::int32_t>{0, 0, 5, 0});
}

TEST_CASE("a class in one group alone cannot be left out, and is named", "[classifier]") {
    FeatureTable rows;
    rows.class_names = {"iron", "wood"};
    rows.label = {0, 0, 1, 1};
    const std::vector<std::int32_t> one_each{4, 4, 5, 5}, two_each{4, 5, 5, 4};
    const std::string problem =
        message_of([&] { expect_groups_in_classes(rows, one_each, LeaveOut::session); });
    CHECK(problem.rfind("/session: all frames of class \"iron\" have one session, 4:", 0) == 0);
    CHECK_NOTHROW(expect_groups_in_classes(rows, two_each, LeaveOut::session));
}

}  // namespace
}  // namespace specula
