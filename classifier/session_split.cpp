#include "classifier/session_split.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

using Session = std::pair<std::int32_t, std::int32_t>;  // (world, number)

Session session_of(const FeatureTable& rows, std::size_t i) {
    return {rows.world[i], rows.session[i]};
}

/// (class) -> its sessions, in their order.
std::map<std::uint8_t, std::vector<Session>> sessions_of_classes(const FeatureTable& rows) {
    std::map<std::uint8_t, std::vector<Session>> sessions;
    std::set<Session> seen;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (seen.insert(session_of(rows, i)).second)
            sessions[rows.label[i]].push_back(session_of(rows, i));
    for (auto& [label, of_class] : sessions) std::ranges::sort(of_class);
    return sessions;
}

std::set<Session> chosen_sessions(const FeatureTable& rows, double share, Stream& stream) {
    std::set<Session> chosen;
    for (auto& [label, sessions] : sessions_of_classes(rows)) {
        const std::size_t n = sessions.size();
        if (n < 2)
            throw InputError(
                format("sessions: class \"{}\" has {} of them, too few to hold one out; record "
                       "more, or train without holding out",
                       rows.class_names[label], n));
        const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(n)));
        const std::size_t n_chosen = std::clamp<std::size_t>(wanted, 1, n - 1);
        for (std::size_t k = 0; k < n_chosen; ++k) {
            const std::size_t pick = k + stream.below(static_cast<std::uint32_t>(n - k));
            std::swap(sessions[k], sessions[pick]);
            chosen.insert(sessions[k]);
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
