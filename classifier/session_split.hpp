#pragma once

#include <vector>

#include "classifier/feature_table.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Rows in two parts that share no session.
struct SessionSplit {
    FeatureTable training;
    FeatureTable held_out;
};

/// Holds out whole sessions: of each class `share` of them, one at least, chosen by chance and
/// spread over the worlds, which are gone through in one order by chance for all classes: where a
/// world has as many sessions of each class, as many of each are held out.
///
/// A session of several classes counts for that of its first row. Sessions are told apart by world
/// and number.
/// @in  share  (0, 1)
/// Throws InputError where a class has a single session, or where all rows of a class would go.
SessionSplit hold_out_sessions(const FeatureTable& rows, double share, const StreamKey& key);

}  // namespace specula
