#pragma once

#include <array>
#include <cstdint>

#include "sim/dataset/truth.hpp"

namespace specula {

/// What readers and writers of dataset files must agree on. FORMAT.md is about this.
namespace dataset_layout {

inline constexpr const char* format_name = "specula-dataset";
inline constexpr int format_version = 3;
/// 1: without left_out, source and sample_axis: all simulated. 2: without /frame_hash, /profile
/// and recipe.
inline constexpr int oldest_version = 1;
inline constexpr const char* left_out_in_version_1 =
    "/adc_quadrature,/profile,/features,/probability,/group/view";

/// Rows per chunk. Each divides the next: writers change tables at multiples of the first only.
inline constexpr std::size_t profile_rows = 256;
inline constexpr std::size_t feature_rows = 4096;
inline constexpr std::size_t column_rows = 1 << 16;  ///< of one-number columns

inline constexpr std::size_t most_features = 4096;
inline constexpr std::size_t most_per_axis = 65535;  ///< chirps, RX or samples: as in a fw_frame

struct IdColumn {
    const char* name;
    const char* meaning;
    std::int32_t Truth::*member;
};
inline constexpr std::array<IdColumn, 4> id_columns{{
    {"/group/world", "draw of room and samples", &Truth::world},
    {"/group/sample", "physical piece", &Truth::sample},
    {"/group/session", "one placement and warm-up", &Truth::session},
    {"/group/frame", "number in its session", &Truth::frame},
}};
inline constexpr IdColumn view_column{
    "/group/view", "side or place from which recordings look at their samples", &Truth::view};

}  // namespace dataset_layout

}  // namespace specula
