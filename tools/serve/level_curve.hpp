#pragma once

#include <atomic>

#include "tools/serve/requested_scene.hpp"
#include "tools/sweep/sweep_plan.hpp"

namespace specula {

enum class CurveAxis { tilt, height };

/// The level of a scene over one of its geometry's numbers, as `specula sweep` computes it: echo
/// alone, speckle in the mean, no session.
struct LevelCurve {
    std::vector<float> x;            ///< degrees, or mm
    std::vector<float> level_db;     ///< tilt: over an infinite mirror there; height: dBm
    std::vector<float> foot_margin;  ///< Fresnel radii between the mirror's foot and the rim
};

/// Of what a curve is made, and what keeps it from running on.
struct CurveRequest {
    CurveAxis axis = CurveAxis::tilt;
    Tilting tilting;
    double most_s = 5.0;  ///< then the curve is as fine as it got; every eighth point always comes
    const std::atomic<bool>& stop;
};

/// Empty where the server stops. Places that the radar cannot see, or where the
/// sample would touch it, are left out.
LevelCurve level_curve(const Scene& scene, const CurveRequest& request, const Library& materials);

/// What the request tilts, be it by nothing.
Tilting tilting_of(const SceneRequest& request);

/// The same as a command on the downloaded scene file.
std::string sweep_command_line(const SceneRequest& request, CurveAxis axis);

}  // namespace specula
