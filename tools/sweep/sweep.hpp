#pragma once

#include <atomic>

#include "tools/sweep/sweep_plan.hpp"

namespace specula {

/// Levels below this are told as this: nothing comes back.
inline constexpr double darkest_db = -300.0;

/// What comes back at one point of the grid.
struct SweepRow {
    SweepIndex at;
    double level_db = darkest_db;        ///< |h|^2, mean over RX, pieces and, without --freq, chirp
    double diffuse_db = darkest_db;      ///< part of it that rough faces scatter
    double over_mirror_db = darkest_db;  ///< over an infinite mirror at the same height
    double over_untilted_db = darkest_db;  ///< over the same specimen untilted
    double over_nominal_db = darkest_db;   ///< over the same untilted at the scene's height
    int peak_bin = 0;                      ///< this and the rest only without --freq
    double centroid_bin = 0.0;
    bool is_weak = false;           ///< PHYSICS.md#limits: coherent echo 15 dB below a wide sheet's
    std::vector<double> bin_lsb{};  ///< (bin) the descriptor's
};

/// Rows in the order specimen, size, tilting, height, tilt, frequency, the last running fastest.
struct Sweep {
    SweepPlan plan;
    std::vector<SweepRow> rows;

    const SweepRow& row(const SweepIndex& at) const;
};

/// How many geometries a sweep traces, those included that only serve as reference.
std::size_t n_traces(const SweepPlan& plan);

/// Simulates the whole grid, every geometry once for all specimens.
///
/// The levels are those of the surface integral with the coefficients of each specimen, and of the
/// speckle of rough faces in the mean over all pieces; the range bins are of the coherent echo. No
/// electronics but the window and the transform. The same numbers for any number of threads.
/// @in  done  counted up once per trace
/// @eq  PHYSICS.md#surface-integral, #speckle, #image-source
Sweep run_sweep(const SweepPlan& plan, const Library& materials, int threads,
                std::atomic<std::size_t>& done);

}  // namespace specula
