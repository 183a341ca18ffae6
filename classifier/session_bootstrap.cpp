#include "classifier/session_bootstrap.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

using Worlds = std::vector<SessionTree::World>;

std::vector<std::size_t> all_sessions(const SessionTree::World& world) {
    std::vector<std::size_t> all;
    for (const auto& of_class : world.sessions)
        all.insert(all.end(), of_class.begin(), of_class.end());
    return all;
}

void draw_sessions(const SessionTree::World& world, Stream& stream,
                   std::vector<std::size_t>& drawn) {
    drawn.clear();
    for (const auto& of_class : world.sessions)
        for (std::size_t k = 0; k < of_class.size(); ++k)
            drawn.push_back(of_class[stream.below(static_cast<std::uint32_t>(of_class.size()))]);
}

Interval percentiles(double mean, std::vector<double> resampled) {
    std::ranges::sort(resampled);
    const std::size_t n_beyond = resampled.size() / 40;  // 2.5 % on either side
    return {.mean = mean,
            .low = resampled[n_beyond],
            .high = resampled[resampled.size() - 1 - n_beyond]};
}

/// @in  whole  (world) -> its value on all its sessions
/// @in  drawn  (world, stream) -> its value on sessions drawn by the stream
template <typename Whole, typename Drawn>
Interval bootstrap(std::size_t n_worlds, const Resampling& resampling, const Whole& whole,
                   const Drawn& drawn) {
    SPECULA_EXPECT(n_worlds > 0 && resampling.n_resamples >= 40);
    const auto n = static_cast<double>(n_worlds);
    double mean = 0.0;
    for (std::size_t w = 0; w < n_worlds; ++w) mean += whole(w) / n;
    Stream stream(resampling.key);
    std::vector<double> resampled(static_cast<std::size_t>(resampling.n_resamples));
    for (double& value : resampled)
        for (std::size_t k = 0; k < n_worlds; ++k)
            value += drawn(stream.below(static_cast<std::uint32_t>(n_worlds)), stream) / n;
    return percentiles(mean, std::move(resampled));
}

}  // namespace

SessionTree session_tree_of(const FeatureTable& rows) {
    SessionTree tree;
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> place;
    std::map<std::int32_t, std::map<std::uint8_t, std::vector<std::size_t>>> worlds;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto [found, is_new] =
            place.try_emplace({rows.world[i], rows.session[i]}, tree.rows.size());
        if (is_new) {
            tree.rows.emplace_back();
            worlds[rows.world[i]][rows.label[i]].push_back(found->second);
        }
        tree.rows[found->second].push_back(i);
    }
    for (auto& [number, of_class] : worlds) {
        tree.worlds.push_back({.number = number, .sessions = {}});
        for (auto& [label, sessions] : of_class)
            tree.worlds.back().sessions.push_back(std::move(sessions));
    }
    return tree;
}

Interval bootstrap_sessions(const SessionTree& tree, const WorldValue& value,
                            const Resampling& resampling) {
    std::vector<std::size_t> drawn;
    return bootstrap(
        tree.worlds.size(), resampling,
        [&](std::size_t world) { return value(all_sessions(tree.worlds[world])); },
        [&](std::size_t world, Stream& stream) {
            draw_sessions(tree.worlds[world], stream, drawn);
            return value(drawn);
        });
}

Interval bootstrap_difference(const SessionTree& tree, const WorldValue& value,
                              const WorldValue& other, const Resampling& resampling) {
    return bootstrap_sessions(
        tree,
        [&](std::span<const std::size_t> sessions) { return value(sessions) - other(sessions); },
        resampling);
}

Interval bootstrap_difference(const Side& a, const Side& b, const Resampling& resampling) {
    SPECULA_EXPECT(a.tree.worlds.size() == b.tree.worlds.size());
    for (std::size_t w = 0; w < a.tree.worlds.size(); ++w)
        SPECULA_EXPECT(a.tree.worlds[w].number == b.tree.worlds[w].number);
    std::vector<std::size_t> drawn;
    const auto drawn_value = [&](const Side& side, std::size_t world, Stream& stream) {
        draw_sessions(side.tree.worlds[world], stream, drawn);
        return side.value(drawn);
    };
    return bootstrap(
        a.tree.worlds.size(), resampling,
        [&](std::size_t world) {
            return a.value(all_sessions(a.tree.worlds[world])) -
                   b.value(all_sessions(b.tree.worlds[world]));
        },
        [&](std::size_t world, Stream& stream) {
            const double of_a = drawn_value(a, world, stream);
            return of_a - drawn_value(b, world, stream);
        });
}

std::vector<Confusion> confusion_per_session(const SessionTree& tree, const FeatureTable& rows,
                                             std::span<const std::uint8_t> predicted) {
    SPECULA_EXPECT(predicted.size() == rows.size());
    std::vector<Confusion> counts(tree.n_sessions(), Confusion(rows.class_names.size()));
    for (std::size_t s = 0; s < tree.n_sessions(); ++s)
        for (const std::size_t i : tree.rows[s]) ++counts[s].at(rows.label[i], predicted[i]);
    return counts;
}

WorldValue macro_f1_value(std::vector<Confusion> per_session, std::vector<int> merged_class) {
    if (!merged_class.empty())
        for (Confusion& counts : per_session) counts = merge_classes(counts, merged_class);
    return [per_session = std::move(per_session)](std::span<const std::size_t> sessions) {
        Confusion sum(per_session.front().n);
        for (const std::size_t s : sessions)
            for (std::size_t i = 0; i < sum.counts.size(); ++i)
                sum.counts[i] += per_session[s].counts[i];
        return macro_f1(sum);
    };
}

WorldValue mean_value(const SessionTree& tree, std::span<const double> per_row) {
    std::vector<std::pair<double, double>> sums;  // (session): of the values, of the rows
    for (const auto& rows : tree.rows) {
        sums.emplace_back(0.0, static_cast<double>(rows.size()));
        for (const std::size_t i : rows) sums.back().first += per_row[i];
    }
    return [sums = std::move(sums)](std::span<const std::size_t> sessions) {
        double sum = 0.0, n = 0.0;
        for (const std::size_t s : sessions) {
            sum += sums[s].first;
            n += sums[s].second;
        }
        return sum / n;
    };
}

}  // namespace specula
