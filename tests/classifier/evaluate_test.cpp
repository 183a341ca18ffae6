#include "classifier/evaluate.hpp"

#include <numeric>
#include <utility>

#include "tests/check.hpp"

namespace specula {
namespace {

const Scoring scoring{.merged_class = {0, 0, 1}, .bootstrap = {.seed = 1, .purpose = "test"}};

WorldOutcome outcome(std::vector<std::uint8_t> truth, std::vector<std::uint8_t> label,
                     std::vector<float> probability) {
    return {.truth = std::move(truth),
            .predictions = {.n_classes = 3,
                            .label = std::move(label),
                            .probability = std::move(probability),
                            .logits = {}}};
}

// World 0: all right. World 1: the metals 0 and 1 are taken for each other.
const std::vector<WorldOutcome> worlds{
    outcome({0, 1, 2}, {0, 1, 2}, {0.99f, 0.97f, 1.0f}),
    outcome({0, 1, 2, 2}, {1, 0, 2, 2}, {0.5f, 0.5f, 0.36f, 1.0f})};

TEST_CASE("a condition is counted over all worlds", "[evaluate]") {
    const ConditionReport report = evaluate("height", "Height 35 cm", worlds, scoring);
    CHECK(report.name == "height");
    CHECK(report.title == "Height 35 cm");
    CHECK(report.n_frames == 7);
    CHECK(report.confusion.counts == std::vector<std::int64_t>{1, 1, 0, 1, 1, 0, 0, 0, 3});
}

TEST_CASE("F1 is one number per world, and merged classes forgive", "[evaluate]") {
    const ConditionReport report = evaluate("a", "A", worlds, scoring);
    REQUIRE(report.macro_f1_per_world.size() == 2);
    CHECK(report.macro_f1_per_world[0] == 1.0);
    CHECK(report.macro_f1_per_world[1] == Approx(1.0 / 3.0));
    CHECK(report.macro_f1_merged_per_world == std::vector<double>{1.0, 1.0});
    CHECK(report.macro_f1.mean == Approx(2.0 / 3.0));
    CHECK(report.macro_f1.low == Approx(1.0 / 3.0));  // of two worlds: all they span
    CHECK(report.macro_f1.high == 1.0);
    CHECK(report.macro_f1_merged.mean == 1.0);
}

TEST_CASE("confidence is counted by right and wrong, 1 in the last bin", "[evaluate]") {
    const ConditionReport report = evaluate("a", "A", worlds, scoring);
    CHECK(report.confidence.correct[24] == 4);  // 0.97, 0.99 and twice 1
    CHECK(report.confidence.correct[9] == 1);   // 0.36 lies just above the edge 9/25
    CHECK(report.confidence.wrong[12] == 2);    // 0.5 in [12/25, 13/25)
    const auto sum = [](const auto& bins) {
        return std::accumulate(bins.begin(), bins.end(), std::int64_t{0});
    };
    CHECK(sum(report.confidence.correct) + sum(report.confidence.wrong) == report.n_frames);
}

TEST_CASE("mean confidence weighs worlds, not frames", "[evaluate]") {
    const ConditionReport report = evaluate("a", "A", worlds, scoring);
    const double first = (0.99 + 0.97 + 1.0) / 3.0;
    const double second = (0.5 + 0.5 + 0.36 + 1.0) / 4.0;
    CHECK(report.mean_confidence.mean == Approx((first + second) / 2.0).epsilon(1e-7));
    CHECK(report.mean_confidence.low == Approx(second).epsilon(1e-7));
    CHECK(report.mean_confidence.high == Approx(first).epsilon(1e-7));
}

}  // namespace
}  // namespace specula
