#include "scenes/scene_checks.hpp"

#include <algorithm>

#include "scenes/mesh_checks.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Nearer than this an antenna's own near field is what counts, and it is not modelled.
constexpr double near_field_m = 0.03;

struct Looked {
    double nearest_m;  ///< to any antenna
    bool is_behind;    ///< all of it, of the antennas' plane
};

Looked look_at(const Mesh& mesh, const Radar& radar, const Placement& placement) {
    Looked looked{distance_m(mesh, placement.point(radar.tx_position_m)), true};
    for (const ReceiveChannel& rx : radar.rx)
        looked.nearest_m =
            std::min(looked.nearest_m, distance_m(mesh, placement.point(rx.position_m)));
    const Vector3 boresight = placement.direction(-Vector3::UnitZ());
    for (const Vector3& vertex : mesh.vertices_m)
        if (boresight.dot(vertex - placement.shift_m) > 0.0) looked.is_behind = false;
    return looked;
}

std::string too_near(const Looked& looked, double wavelength_m) {
    return looked.nearest_m < wavelength_m
               ? format("comes within {:.2g} mm of an antenna", looked.nearest_m * 1e3)
               : "";
}

void warn(const std::string& name, const Looked& looked, Scene& scene) {
    if (looked.is_behind)
        scene.warnings.push_back(name + " lies behind the antennas, which do not see it");
    else if (looked.nearest_m < near_field_m)
        scene.warnings.push_back(
            format("{} comes within {:.2g} mm of an antenna; below {:.0f} mm the antenna's near "
                   "field counts, which is not modelled",
                   name, looked.nearest_m * 1e3, near_field_m * 1e3));
    if (looked.nearest_m > scene.radar.chirp.max_range_m())
        scene.warnings.push_back(
            format("{} is beyond the farthest range of the chirp, {:.3g} m; "
                   "it shows in a bin that is not its own",
                   name, scene.radar.chirp.max_range_m()));
}

}  // namespace

void check_places(Section& geometry, Section& root, Scene& scene) {
    const double wavelength_m = speed_of_light_m_s / scene.radar.chirp.centre_hz();
    const Placement radar = radar_placement(scene.pose);
    const Mesh sample = scene.sample.triangles(sample_placement(scene.pose));
    const Looked at_sample = look_at(sample, scene.radar, radar);
    if (const std::string problem = too_near(at_sample, wavelength_m); !problem.empty())
        geometry.fail_quantity("height", Unit::length, "the sample " + problem,
                               "raise the radar, tilt less, or move the pivot");
    warn("the sample", at_sample, scene);
    if (scene.sample_is_watertight && encloses(sample, radar.shift_m))
        scene.warnings.push_back("the radar stands inside the sample and sees its inner faces");
    for (const SceneObject& object : scene.objects) {
        const Mesh mesh = object.matter.triangles(object.placement(scene.pose));
        const Looked looked = look_at(mesh, scene.radar, radar);
        if (const std::string problem = too_near(looked, wavelength_m); !problem.empty())
            root.fail("object", object.name + " " + problem, "move the object or the radar");
        warn(object.name, looked, scene);
        if (object.is_watertight && encloses(mesh, radar.shift_m))
            scene.warnings.push_back("the radar stands inside " + object.name +
                                     " and sees its inner faces");
    }
}

}  // namespace specula
