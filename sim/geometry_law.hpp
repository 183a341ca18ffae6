#pragma once

#include <array>

#include "scenes/pose.hpp"
#include "scenes/radar.hpp"
#include "sim/core/constants.hpp"
#include "sim/spread_draws.hpp"

namespace specula {

/// Tilts of experiments end here: a sample seen from its edge returns next to nothing.
inline constexpr double steepest_tilt_rad = 85.0 * pi / 180.0;

/// How radar and sample stand to each other in the sessions of a dataset, before the errors of each
/// session: laws of height, tilts, offset and turn, each spread over the sessions of a class.
struct GeometryLaw {
    static constexpr std::size_t n_axes = 8;

    std::array<SampledLaw, n_axes> laws;  ///< in the order of geometry_axis_names
    Vector3 pivot_m = Vector3::Zero();    ///< about which tilted samples turn
    int n_sessions = 1;                   ///< of a class in all worlds

    /// @in  item  group: the class; index: number of its session over all worlds
    Pose pose(const SpreadItem& item) const;
};

/// The keys of [geometry], without their units.
std::array<std::string_view, GeometryLaw::n_axes> geometry_axis_names();

/// Reads [geometry]; the height defaults to the nominal one, all else to nothing. Refuses heights
/// that the radar cannot see, of all that can be drawn.
GeometryLaw read_geometry(Section section, const Radar& radar, double nominal_height_m);

}  // namespace specula
