#pragma once

#include <compare>
#include <map>

#include "tools/sweep/sweep_plan.hpp"

namespace specula {

/// How one trace of a sweep lies. Without a tilt it does not matter what would be tilted.
struct SweepGeometry {
    double size_x_m = 0.0, size_y_m = 0.0, height_m = 0.0, tilt_rad = 0.0;
    bool sensor = false, elevation = false;

    auto operator<=>(const SweepGeometry&) const = default;
    Plate face(const Plate& of_scene) const;
    Pose pose(const Pose& of_scene) const;
};

SweepGeometry geometry_at(const SweepPlan& plan, const SweepIndex& at);
/// The same size untilted: at its own height, or at that of the scene.
SweepGeometry untilted(SweepGeometry geometry);
SweepGeometry nominal(SweepGeometry geometry, const SweepPlan& plan);

/// Every geometry that a sweep needs, once, with its number.
std::map<SweepGeometry, std::size_t> numbered_geometries(const SweepPlan& plan);

/// Calls `visit` for every point of the grid but for specimens and frequencies.
template <typename Visit>
void for_each_geometry(const SweepPlan& plan, const Visit& visit) {
    SweepIndex at;
    for (at.size = 0; at.size < plan.sizes_m.size(); ++at.size)
        for (at.tilting = 0; at.tilting < plan.tiltings.size(); ++at.tilting)
            for (at.height = 0; at.height < plan.heights_m.size(); ++at.height)
                for (at.tilt = 0; at.tilt < plan.tilts_rad.size(); ++at.tilt) visit(at);
}

}  // namespace specula
