#pragma once

#include <string>
#include <vector>

#include "sim/dataset/truth.hpp"

namespace specula {

/// Whether what a classifier must not see is drawn alike for all classes.
struct SameLaws {
    std::size_t n_tests = 0;
    double smallest_p = 1.0;  ///< of all tests
    std::string column;       ///< where it is
    std::size_t label = 0;

    /// Times the number of tests (Bonferroni), at most 1.
    double corrected_p() const;
};

/// Compares, for each class against the others, the sessions' heights, tilts, places and gains and
/// the frames' displacements, by the two-sample Kolmogorov-Smirnov test. One value per session,
/// that of its first frame, since frames of a session share them.
/// @eq  N. Smirnov 1948, Ann. Math. Statist. 19, 279: p = 2 sum (-1)^(j-1) exp(-2 j^2 x^2)
SameLaws compare_nuisance(const std::vector<Truth>& truth, std::size_t n_classes);

}  // namespace specula
