#pragma once

#include <cstdint>
#include <string_view>

#include "sim/core/distribution.hpp"

namespace specula {

/// One of many items over which the draws of some axes are spread.
struct SpreadItem {
    std::uint64_t seed = 0;
    std::uint32_t group = 0;  ///< items of other groups are spread independently
    std::uint32_t index = 0;  ///< in [0, n)
    std::uint32_t n = 1;      ///< of the group; only stratified draws depend on it
};

/// Which of the numbers that an item draws.
struct SpreadAxis {
    std::string_view name;  ///< keys its random numbers
    int dimension = 0;      ///< of the quasi-random sequence, in [0, most_dimensions)

    static constexpr int most_dimensions = 8;
};

/// A number in (0, 1) for an item, so that those of all items are spread evenly.
///
/// stratified  Latin hypercube: one of n equal parts each, in an order drawn for the axis
///             (McKay, Beckman, Conover 1979)
/// quasi       Sobol's sequence with the directions of Joe and Kuo (2008), shifted digit by digit:
///             any 2^k items that follow each other from a multiple of 2^k fill each 2^-k of the
///             interval once, and pairs of axes likewise
/// @eq PHYSICS.md#spread-draws
double spread_uniform(const SpreadItem& item, const SpreadAxis& axis, Sampling sampling);

}  // namespace specula
