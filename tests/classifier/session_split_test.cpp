#include "classifier/session_split.hpp"

#include <map>
#include <set>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

constexpr StreamKey split_key{.seed = 2, .purpose = "split test"};

/// `n_sessions` of each of three classes in two worlds, four rows each.
FeatureTable sessions_recorded(int n_sessions) {
    FeatureTable rows;
    rows.n_features = 1;
    rows.class_names = {"a", "b", "c"};
    for (int world = 0; world < 2; ++world)
        for (int session = 0; session < 3 * n_sessions; ++session)
            for (int frame = 0; frame < 4; ++frame) {
                rows.features.push_back(static_cast<float>(session));
                rows.label.push_back(static_cast<std::uint8_t>(session % 3));
                rows.world.push_back(world);
                rows.session.push_back(session);
            }
    return rows;
}

std::set<std::pair<int, int>> sessions(const FeatureTable& rows) {
    std::set<std::pair<int, int>> found;
    for (std::size_t i = 0; i < rows.size(); ++i) found.insert({rows.world[i], rows.session[i]});
    return found;
}

TEST_CASE("no session is on both sides, none is lost, and every class is on both", "[split]") {
    const FeatureTable rows = sessions_recorded(5);
    const SessionSplit split = hold_out_sessions(rows, 0.2, split_key);
    const auto training = sessions(split.training), held_out = sessions(split.held_out);
    CHECK(training.size() + held_out.size() == 30);
    for (const auto& session : held_out) CHECK_FALSE(training.contains(session));
    CHECK(held_out.size() == 6);  // two of ten, of each of three classes
    std::map<int, int> of_class;
    for (const std::uint8_t label : split.held_out.label) ++of_class[label];
    CHECK(of_class == std::map<int, int>{{0, 8}, {1, 8}, {2, 8}});
    CHECK(split.training.size() + split.held_out.size() == rows.size());
}

TEST_CASE("the share is rounded, but each side keeps a session of each class", "[split]") {
    CHECK(sessions(hold_out_sessions(sessions_recorded(1), 0.01, split_key).held_out).size() == 3);
    CHECK(sessions(hold_out_sessions(sessions_recorded(1), 0.99, split_key).training).size() == 3);
}

TEST_CASE("worlds that hold all classes alike keep all classes on the side held out", "[split]") {
    // Two worlds of one to five sessions a class; ever so drawn, no world lacks a class.
    for (int n_sessions = 1; n_sessions <= 5; ++n_sessions)
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const SessionSplit split = hold_out_sessions(sessions_recorded(n_sessions), 0.3,
                                                         {.seed = seed, .purpose = "split test"});
            std::map<int, std::map<int, int>> rows;  // (world) -> (class) -> rows
            for (std::size_t i = 0; i < split.held_out.size(); ++i)
                ++rows[split.held_out.world[i]][split.held_out.label[i]];
            for (const auto& [world, of_class] : rows) {
                REQUIRE(of_class.size() == 3);
                CHECK((of_class.at(0) == of_class.at(1) && of_class.at(1) == of_class.at(2)));
            }
        }
    std::set<int> chosen;  // one session a class and world: which world goes is by chance
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        chosen.insert(
            hold_out_sessions(sessions_recorded(1), 0.3, {.seed = seed, .purpose = "split test"})
                .held_out.world.front());
    CHECK(chosen == std::set<int>{0, 1});
}

TEST_CASE("another key holds out other sessions, the same key the same", "[split]") {
    const FeatureTable rows = sessions_recorded(20);
    const auto first = sessions(hold_out_sessions(rows, 0.3, split_key).held_out);
    CHECK(sessions(hold_out_sessions(rows, 0.3, split_key).held_out) == first);
    CHECK(sessions(hold_out_sessions(rows, 0.3, {.seed = 3, .purpose = "split test"}).held_out) !=
          first);
}

TEST_CASE("a class with a single session, and sessions of mixed classes, are refused", "[split]") {
    FeatureTable rows = sessions_recorded(1);
    rows = select_rows_where(
        rows, [&](std::size_t i) { return rows.label[i] != 1 || rows.world[i] == 0; });
    CHECK(message_of([&] { return hold_out_sessions(rows, 0.2, split_key).training.size(); }) ==
          "sessions: class \"b\" has 1 of them, too few to hold one out; record more, or train "
          "without holding out");

    // Class b only occurs in session 1, behind a first row of class a.
    FeatureTable mixed;
    mixed.n_features = 1;
    mixed.class_names = {"a", "b"};
    mixed.label = {0, 0, 0, 1};
    mixed.features = {1, 2, 3, 4};
    mixed.world = {0, 0, 0, 0};
    mixed.session = {0, 0, 1, 1};
    int n_refused = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::string message = message_of([&] {
            const StreamKey other{.seed = seed, .purpose = "split test"};
            return hold_out_sessions(mixed, 0.5, other).training.size();
        });
        n_refused += message.rfind("sessions: all rows of class \"b\" would be held out", 0) == 0;
    }
    CHECK((n_refused > 2 && n_refused < 18));  // one of two sessions, by chance
}

}  // namespace
}  // namespace specula
