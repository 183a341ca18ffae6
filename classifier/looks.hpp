#pragma once

#include "classifier/feature_table.hpp"

namespace specula {

/// How several frames become one row.
struct Looks {
    std::size_t count = 1;  ///< consecutive frames of a session, >= 2
    bool spread = false;    ///< also the standard deviation of every feature over them
};

/// Means over consecutive rows of each session, and their spread: what moves between frames (the
/// sample's or the mounting's vibration, noise) shows in the spread and averages out of the mean.
///
/// Rows of a session that do not fill the last group are left out.
/// @out  (group, features), or (group, 2 features): the means, then the standard deviations
/// Throws InputError where no session has that many rows.
FeatureTable combine_looks(const FeatureTable& rows, const Looks& looks);

/// The row of `rows` with which each row of combine_looks begins.
std::vector<std::size_t> first_rows(const FeatureTable& rows, const Looks& looks);

}  // namespace specula
