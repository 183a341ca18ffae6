#include "classifier/session_split.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

using Session = std::pair<std::int32_t, std::int32_t>;  // (world, number)

Session session_of(const FeatureTable& rows, std::size_t i) {
    return {rows.world[i], rows.session[i]};
}

/// (class) -> its sessions, world by world in the order given, in a world in their own.
std::map<std::uint8_t, std::vector<Session>> sessions_of_classes(
    const FeatureTable& rows, const std::vector<std::int32_t>& worlds) {
    std::map<std::int32_t, std::size_t> place;
    for (std::size_t w = 0; w < worlds.size(); ++w) place[worlds[w]] = w;
    std::map<std::uint8_t, std::vector<Session>> sessions;
    std::set<Session> seen;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (seen.insert(session_of(rows, i)).second)
            sessions[rows.label[i]].push_back(session_of(rows, i));
    for (auto& [label, of_class] : sessions)
        std::ranges::sort(of_class, {}, [&](const Session& session) {
            return std::pair{place.at(session.first), session.second};
        });
    return sessions;
}

/// The first n_wanted places become a draw without replacement.
template <typename T>
void draw_first(std::span<T> items, std::size_t n_wanted, Stream& stream) {
    for (std::size_t k = 0; k < n_wanted; ++k) {
        const std::size_t pick = k + stream.below(static_cast<std::uint32_t>(items.size() - k));
        std::swap(items[k], items[pick]);
    }
}

std::vector<std::int32_t> worlds_by_chance(const FeatureTable& rows, Stream& stream) {
    const std::set<std::int32_t> sorted(rows.world.begin(), rows.world.end());
    std::vector<std::int32_t> worlds(sorted.begin(), sorted.end());
    draw_first(std::span(worlds), worlds.empty() ? 0 : worlds.size() - 1, stream);
    return worlds;
}

/// Of n_chosen among n, how many fall to the first n_passed: rounded, so that worlds share them.
std::size_t chosen_among_first(std::size_t n_passed, std::size_t n_chosen, std::size_t n) {
    return (2 * n_chosen * n_passed + n) / (2 * n);
}

std::set<Session> chosen_sessions(const FeatureTable& rows, double share, Stream& stream) {
    std::set<Session> chosen;
    for (auto& [label, sessions] : sessions_of_classes(rows, worlds_by_chance(rows, stream))) {
        const std::size_t n = sessions.size();
        if (n < 2)
            throw InputError(
                format("sessions: class \"{}\" has {} of them, too few to hold one out; record "
                       "more, or train without holding out",
                       rows.class_names[label], n));
        const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(n)));
        const std::size_t n_chosen = std::clamp<std::size_t>(wanted, 1, n - 1);
        for (std::size_t first = 0; first < n;) {
            std::size_t last = first;
            while (last < n && sessions[last].first == sessions[first].first) ++last;
            const auto of_world = std::span(sessions).subspan(first, last - first);
            const std::size_t n_of_world =
                chosen_among_first(last, n_chosen, n) - chosen_among_first(first, n_chosen, n);
            draw_first(of_world, n_of_world, stream);
            for (std::size_t k = 0; k < n_of_world; ++k) chosen.insert(of_world[k]);
            first = last;
        }
    }
    return chosen;
}

}  // namespace

SessionSplit hold_out_sessions(const FeatureTable& rows, double share, const StreamKey& key) {
    SPECULA_EXPECT(share > 0.0 && share < 1.0);
    Stream stream(key);
    const std::set<Session> chosen = chosen_sessions(rows, share, stream);
    const auto is_held_out = [&](std::size_t i) { return chosen.contains(session_of(rows, i)); };
    SessionSplit split{
        .training = select_rows_where(rows, [&](std::size_t i) { return !is_held_out(i); }),
        .held_out = select_rows_where(rows, is_held_out)};
    const std::set<std::uint8_t> kept(split.training.label.begin(), split.training.label.end());
    for (const std::uint8_t label : rows.label)
        if (!kept.contains(label))
            throw InputError(
                format("sessions: all rows of class \"{}\" would be held out; record sessions of "
                       "one class each",
                       rows.class_names[label]));
    return split;
}

}  // namespace specula
