#pragma once

#include <functional>
#include <span>
#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/report.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// The sessions of a table, world by world. Frames of a session are no independent observations, so
/// nothing below a session is ever drawn.
struct SessionTree {
    struct World {
        std::int32_t number = 0;
        /// (class) -> its sessions in this world, as places in `rows`; classes without any left out
        std::vector<std::vector<std::size_t>> sessions;
    };
    std::vector<World> worlds;                   ///< by number
    std::vector<std::vector<std::size_t>> rows;  ///< (session, .) -> rows of the table

    std::size_t n_sessions() const { return rows.size(); }
};

/// A session of several classes counts for that of its first row.
SessionTree session_tree_of(const FeatureTable& rows);

/// What a world comes to on these of its sessions; one may be named more than once.
using WorldValue = std::function<double(std::span<const std::size_t> sessions)>;

struct Resampling {
    int n_resamples = 2000;  ///< >= 40
    StreamKey key;           ///< one for all quantities, so that they share their draws
};

/// Mean over worlds with its 95 % interval by the hierarchical bootstrap: worlds are drawn with
/// replacement, then within each the sessions of every class (so that no class gets lost).
/// @in  tree  at least one world
/// @eq  Davison and Hinkley 1997, Bootstrap Methods and their Application, section 3.8
/// Limit: with one world, its spread is that of its sessions alone; with few, it is too narrow.
Interval bootstrap_sessions(const SessionTree& tree, const WorldValue& value,
                            const Resampling& resampling);

/// The same for value - other where both come from one table, such as two models on the same
/// frames: every draw compares them on the same sessions.
Interval bootstrap_difference(const SessionTree& tree, const WorldValue& value,
                              const WorldValue& other, const Resampling& resampling);

/// One side of a comparison between tables.
struct Side {
    const SessionTree& tree;
    const WorldValue& value;
};
/// a - b where the tables differ, such as two conditions of the same worlds: worlds are drawn
/// together, sessions of each on their own.
/// @in  a, b  the same world numbers
Interval bootstrap_difference(const Side& a, const Side& b, const Resampling& resampling);

/// Confusion counts of every session of the tree.
std::vector<Confusion> confusion_per_session(const SessionTree& tree, const FeatureTable& rows,
                                             std::span<const std::uint8_t> predicted);

/// Macro-F1 of sessions put together.
/// @in  per_session   kept by the value that is returned
/// @in  merged_class  as merge_classes takes it; empty: classes as they are
WorldValue macro_f1_value(std::vector<Confusion> per_session, std::vector<int> merged_class = {});

/// Mean over all rows of sessions, such as of a negative log-likelihood.
/// @in  per_row  (row of the table)
WorldValue mean_value(const SessionTree& tree, std::span<const double> per_row);

}  // namespace specula
