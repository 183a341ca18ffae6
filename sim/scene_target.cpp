#include "sim/scene_target.hpp"

#include "materials/transmission.hpp"

namespace specula {

namespace {

/// Twice 60 dB lie below any noise here.
constexpr double least_power_through = 1e-6;

/// The turn of an object about the vertical: it carries the grain with it.
double yaw_of(const Placement& placement) {
    return std::atan2(placement.rotation(1, 0), placement.rotation(0, 0));
}

Body body_of(const Sample& matter, const Placement& placement, bool opaque) {
    const double thickness_m = opaque ? 0.0 : matter.thickness_m;
    return matter.mesh ? mesh_body(placed(*matter.mesh, placement), opaque, thickness_m)
                       : plate_body(matter.face, placement, opaque, thickness_m);
}

}  // namespace

std::vector<Reflector> reflectors_of(const Scene& scene, const Library& materials) {
    std::vector<Reflector> reflectors{reflector_of(scene.sample, materials, scene.pose.yaw_rad)};
    for (const SceneObject& object : scene.objects)
        reflectors.push_back(
            reflector_of(object.matter, materials, yaw_of(object.placement(scene.pose))));
    return reflectors;
}

bool is_opaque(const Sample& matter, const Reflector& reflector, double frequency_hz) {
    if (matter.opaque) return *matter.opaque;
    if (matter.mesh || matter.backing != "air") return true;
    const Transmission through = stack_transmission(reflector(frequency_hz), 1.0);
    return std::norm(through.te) < least_power_through;
}

Target target_of(const Scene& scene, std::span<const Reflector> reflectors) {
    const double centre_hz = scene.radar.chirp.centre_hz();
    // With nothing behind it, what comes through a sample is lost.
    const bool sample_opaque =
        scene.objects.empty() || is_opaque(scene.sample, reflectors[0], centre_hz);
    std::vector<Body> bodies{body_of(scene.sample, sample_placement(scene.pose), sample_opaque)};
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        bodies.push_back(body_of(object.matter, object.placement(scene.pose),
                                 is_opaque(object.matter, reflectors[i + 1], centre_hz)));
    }
    return Target(std::move(bodies));
}

}  // namespace specula
