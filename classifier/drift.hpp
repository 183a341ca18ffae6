#pragma once

#include <vector>

#include "classifier/feature_table.hpp"

namespace specula {

/// Two tables of the same features: what is familiar, and what is asked about.
struct TablePair {
    const FeatureTable& familiar;  ///< at least two rows
    const FeatureTable& asked;     ///< at least two rows
};

/// Population stability index of every feature: sum over ten bins that hold a tenth of the familiar
/// rows each of (q - p) ln(q / p). Half a row is added to each bin, so that an empty one counts and
/// does not make it infinite.
///
/// 0: the same; by custom, above 0.1 some and above 0.25 much drift.
/// @out  (feature), >= 0
/// @eq   Siddiqi 2006, Credit Risk Scorecards, chapter 9
std::vector<double> population_stability(const TablePair& tables);

/// |mean of the asked - mean of the familiar| over the standard deviation of the familiar, which is
/// taken as a millionth of the mean at least: a feature that was constant and moved gives a large
/// number, not infinity.
/// @out  (feature), >= 0
std::vector<double> mean_shift(const TablePair& tables);

struct MmdOptions {
    std::size_t max_rows = 1000;  ///< of each table, evenly spread over it, >= 2
};

/// Squared maximum mean discrepancy, unbiased, with the kernel exp(-d^2 / (2 s^2)) on features
/// standardised by the familiar rows; s is the median distance between the rows of both. Near 0 for
/// the same distribution, then also below 0.
/// @eq  Gretton et al. 2012, JMLR 13, lemma 6 and section 8
double mean_discrepancy(const TablePair& tables, const MmdOptions& options = {});

}  // namespace specula
