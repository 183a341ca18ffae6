#include "classifier/session_bootstrap.hpp"

#include <cmath>
#include <map>

#include "classifier/metrics.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

const Resampling resampling{.n_resamples = 2000,
                            .key = {.seed = 1, .purpose = "session bootstrap test"}};

struct Recorded {
    int n_worlds = 5;
    int n_sessions = 4;  ///< of each of two classes
    int n_frames = 3;
};

FeatureTable recorded(const Recorded& shape) {
    FeatureTable rows;
    rows.n_features = 0;
    rows.class_names = {"a", "b"};
    for (int world = 0; world < shape.n_worlds; ++world)
        for (int session = 0; session < 2 * shape.n_sessions; ++session)
            for (int frame = 0; frame < shape.n_frames; ++frame) {
                rows.label.push_back(static_cast<std::uint8_t>(session % 2));
                rows.world.push_back(world);
                rows.session.push_back(session);
            }
    return rows;
}

/// Effects of worlds and sessions, and how much of each.
std::vector<double> nested_values(const FeatureTable& rows, double world_sd, double session_sd) {
    std::map<int, double> of_world;
    std::map<std::pair<int, int>, double> of_session;
    Stream stream({.seed = 7, .purpose = "session bootstrap test"});
    std::vector<double> values;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!of_world.contains(rows.world[i])) of_world[rows.world[i]] = world_sd * stream.normal();
        const std::pair session{rows.world[i], rows.session[i]};
        if (!of_session.contains(session)) of_session[session] = session_sd * stream.normal();
        values.push_back(of_world[rows.world[i]] + of_session[session]);
    }
    return values;
}

double width(const Interval& interval) {
    return interval.high - interval.low;
}

TEST_CASE("sessions are found world by world and class by class", "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 2, .n_sessions = 3, .n_frames = 2});
    const SessionTree tree = session_tree_of(rows);
    REQUIRE(tree.worlds.size() == 2);
    CHECK(tree.n_sessions() == 12);
    for (const auto& world : tree.worlds) {
        REQUIRE(world.sessions.size() == 2);
        CHECK((world.sessions[0].size() == 3 && world.sessions[1].size() == 3));
    }
    for (const auto& session : tree.rows) CHECK(session.size() == 2);
}

TEST_CASE("where worlds differ and sessions do not, the interval is that of worlds",
          "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 60});
    const SessionTree tree = session_tree_of(rows);
    const auto values = nested_values(rows, 1.0, 0.0);
    const Interval found = bootstrap_sessions(tree, mean_value(tree, values), resampling);
    std::vector<double> per_world;
    for (std::size_t i = 0; i < rows.size(); i += 24) per_world.push_back(values[i]);
    const Interval plain = bootstrap_mean(per_world, resampling.key);
    CHECK(found.mean == Approx(plain.mean).epsilon(1e-12));
    CHECK(width(found) == Approx(width(plain)).epsilon(0.08));  // 2,000 draws: 3 % each end
}

TEST_CASE("where sessions differ, frames of one do not count as more", "[bootstrap]") {
    // A mean of 2 * 40 sessions of unit spread: standard error sqrt(1 / 80), whatever the frames.
    const auto widths = [](int n_frames) {
        const FeatureTable rows = recorded({.n_worlds = 1, .n_sessions = 40, .n_frames = n_frames});
        const SessionTree tree = session_tree_of(rows);
        const auto values = nested_values(rows, 0.0, 1.0);
        return width(bootstrap_sessions(tree, mean_value(tree, values), resampling));
    };
    CHECK(widths(2) == Approx(widths(50)).epsilon(1e-9));
    CHECK(widths(2) == Approx(2.0 * 1.96 / std::sqrt(80.0)).epsilon(0.25));  // 80 values' own sd
}

TEST_CASE("no draw loses a class", "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 3, .n_sessions = 1});
    const SessionTree tree = session_tree_of(rows);
    const std::vector<std::uint8_t> right = rows.label;
    const auto value = macro_f1_value(confusion_per_session(tree, rows, right));
    const Interval all_right = bootstrap_sessions(tree, value, resampling);
    CHECK((all_right.low == 1.0 && all_right.high == 1.0));
}

TEST_CASE("macro-F1 of all sessions together is that of the whole table", "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 1, .n_sessions = 6, .n_frames = 5});
    Stream stream({.seed = 3, .purpose = "session bootstrap test"});
    std::vector<std::uint8_t> predicted;
    for (const std::uint8_t label : rows.label)
        predicted.push_back(stream.uniform() < 0.7 ? label : std::uint8_t(1 - label));
    const SessionTree tree = session_tree_of(rows);
    const auto counts = confusion_per_session(tree, rows, predicted);
    const Interval found = bootstrap_sessions(tree, macro_f1_value(counts), resampling);
    CHECK(found.mean == macro_f1(confusion_of(rows.label, predicted, 2)));
    CHECK((found.low < found.mean && found.mean < found.high));
    const std::vector<int> together{0, 0};
    CHECK(bootstrap_sessions(tree, macro_f1_value(counts, together), resampling).low == 1.0);
}

TEST_CASE("a paired difference is as sure as the difference, not as its parts", "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 20});
    const SessionTree tree = session_tree_of(rows);
    const auto values = nested_values(rows, 1.0, 1.0);
    std::vector<double> more = values;
    for (double& value : more) value += 0.125;
    const Interval difference =
        bootstrap_difference(tree, mean_value(tree, more), mean_value(tree, values), resampling);
    CHECK(difference.low == Approx(0.125).epsilon(1e-9));
    CHECK(difference.high == Approx(0.125).epsilon(1e-9));
    CHECK(width(bootstrap_sessions(tree, mean_value(tree, values), resampling)) > 0.3);
}

TEST_CASE("conditions of the same worlds share worlds, not sessions", "[bootstrap]") {
    const FeatureTable rows = recorded({.n_worlds = 20});
    const SessionTree tree = session_tree_of(rows);
    const auto of_worlds = nested_values(rows, 1.0, 0.0);
    const auto value = mean_value(tree, of_worlds);
    const Interval same = bootstrap_difference({tree, value}, {tree, value}, resampling);
    CHECK((same.low == 0.0 && same.high == 0.0));
    const auto of_sessions = nested_values(rows, 0.0, 1.0);
    const auto other = mean_value(tree, of_sessions);
    CHECK(width(bootstrap_difference({tree, other}, {tree, other}, resampling)) > 0.1);
}

}  // namespace
}  // namespace specula
