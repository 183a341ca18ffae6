#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/pose.hpp"
#include "scenes/radar.hpp"
#include "sim/geometry_law.hpp"

namespace specula {

/// One set of recordings: which samples, at which heights and tilts, how many of them.
struct Condition {
    std::string name;
    std::string title;
    int number = 0;                    ///< place in the experiment; keys its random numbers
    std::vector<double> heights_m;     ///< recorded at each of these ...
    std::vector<double> tilts_rad{0.0};  ///< ... with each of these
    bool tilts_sensor = true;          ///< else the sample, about the pivot
    bool elevation = false;            ///< plane of the tilt
    Vector3 pivot_m = Vector3::Zero();
    bool new_samples = false;          ///< other pieces than those of the training recordings
    int sessions = 1;                  ///< per class, height and tilt
    int sessions_per_piece = 1;        ///< that new samples stay for
    std::optional<GeometryLaw> geometry_law{};  ///< instead of heights and tilts
    int frames = 1;                    ///< per session

    static constexpr int most_sessions = 1024;  ///< over heights and tilts, per class
    static constexpr int most_frames = 4096;
    static constexpr int most_conditions = 16;

    int geometries() const { return static_cast<int>(heights_m.size() * tilts_rad.size()); }
    int sessions_per_class() const { return geometries() * sessions; }
    /// Without a geometry law: the pose of the bench drawing for session number `session` in [0, sessions_per_class()).
    Pose pose(int session) const;
};

/// Reads one [[condition]] (or [training]); heights default to the nominal one. Refuses heights
/// that the radar cannot see.
Condition read_condition(Section section, const Radar& radar, double nominal_height_m, int number);

}  // namespace specula
