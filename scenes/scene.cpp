#include "scenes/scene.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/sample_layers.hpp"
#include "scenes/scene_checks.hpp"
#include "scenes/scene_text.hpp"
#include "scenes/shape.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double steepest_rad = 85.0 * pi / 180.0;

void read_sample(Section section, const Catalogue& catalogue, Scene& scene) {
    Sample& sample = scene.sample;
    scene.sample_is_watertight = read_shape(section, sample, scene.warnings);
    if (sample.mesh && section.has_quantity("rotation", Unit::angle))
        sample.mesh = std::make_shared<const Mesh>(
            placed(*sample.mesh, {read_rotation(section), Vector3::Zero()}));
    read_matter(section, catalogue, sample);
    section.finish();
}

void read_objects(Section& section, const Catalogue& catalogue, Scene& scene) {
    for (Section& object : section.sections("object")) {
        if (scene.objects.size() == Scene::most_objects)
            section.fail("object", "too many objects",
                         format("describe at most {}", Scene::most_objects));
        const int number = static_cast<int>(scene.objects.size()) + 1;
        scene.objects.push_back(read_object(object, catalogue, number, scene.warnings));
    }
}

}  // namespace

Pose read_pose(Section section) {
    Pose pose;
    pose.height_m = section.quantity("height", Unit::length, Range::inside(0.0, 100.0));
    const double tilt_rad =
        section.quantity("tilt", Unit::angle, Range::between(-steepest_rad, steepest_rad), 0.0);
    const std::string axis = section.choice("tilt_plane", {"azimuth", "elevation"}, "azimuth");
    const std::string tilted = section.choice("tilted", {"sensor", "sample"}, "sensor");
    Pose::Tilt& tilt = tilted == "sensor" ? pose.sensor : pose.sample;
    (axis == "azimuth" ? tilt.about_y_rad : tilt.about_x_rad) = tilt_rad;
    if (section.has_quantity("pivot", Unit::length)) {
        const auto p = section.quantities("pivot", Unit::length, 3, Range::between(-10.0, 10.0));
        if (tilted == "sensor")
            section.fail_quantity("pivot", Unit::length,
                                  "a tilted sensor turns about its own phase centre",
                                  "remove it, or write tilted = \"sample\"");
        pose.pivot_m = {p[0], p[1], p[2]};
    }
    if (section.has_quantity("offset", Unit::length)) {
        const auto o = section.quantities("offset", Unit::length, 2, Range::between(-10.0, 10.0));
        pose.offset_x_m = o[0];
        pose.offset_y_m = o[1];
    }
    pose.yaw_rad = section.quantity("yaw", Unit::angle, Range::between(-pi, pi), 0.0);
    section.finish();
    return pose;
}

namespace {

void warn_of_roughness(Scene& scene) {
    if (scene.solver.roughness == Solver::Roughness::coherent) return;
    const FrequencyBand band = scene.radar.chirp.band();
    const auto add = [&](const Sample& matter) {
        for (const std::string& warning : roughness_warnings(matter, band))
            scene.warnings.push_back(warning);
    };
    add(scene.sample);
    for (const SceneObject& object : scene.objects) add(object.matter);
}

}  // namespace

std::string blind_reason(const Radar& radar, double height_m) {
    if (height_m > radar.chirp.max_range_m())
        return format("is beyond the farthest range of the chirp of {}, {:.3g} m", radar.name,
                      radar.chirp.max_range_m());
    if (radar.chirp.bin_of(height_m) < 3.0)
        return format("is bin {:.2f} of the chirp of {}, among bins 0 to 2, where boards leak",
                      radar.chirp.bin_of(height_m), radar.name);
    return "";
}

namespace {

Scene scene_of(Section section, const Catalogue& catalogue) {
    Scene scene;
    scene.radar = catalogue.radar(section, "radar");
    read_sample(section.section("sample"), catalogue, scene);
    Section geometry = section.section("geometry");
    scene.pose = read_pose(geometry);
    const std::string blind = blind_reason(scene.radar, scene.pose.height_m);
    if (!blind.empty())
        geometry.fail_quantity("height", Unit::length, blind,
                               format("choose a height of {:.0f} to {:.0f} mm, or another radar",
                                      std::ceil(3e3 * scene.radar.chirp.bin_m()),
                                      std::floor(1e3 * scene.radar.chirp.max_range_m())));
    read_objects(section, catalogue, scene);
    scene.solver = read_solver(section);
    warn_of_roughness(scene);
    check_places(geometry, section, scene);
    if (auto motion = section.find_section("motion")) scene.motion = Motion::read(*motion);
    section.finish();
    return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const Catalogue& catalogue) {
    return scene_of(Section::read(file), catalogue);
}

Scene read_scene_text(const std::string& text, const std::string& name,
                      const Catalogue& catalogue) {
    return scene_of(Section::parse(text, name), catalogue);
}

std::vector<BandWarning> band_warnings(const Scene& scene, const Library& library) {
    const FrequencyBand band = scene.radar.chirp.band();
    std::vector<BandWarning> warnings = band_warnings(scene.sample, library, band);
    for (const SceneObject& object : scene.objects)
        for (const BandWarning& warning : band_warnings(object.matter, library, band))
            if (std::none_of(warnings.begin(), warnings.end(), [&](const BandWarning& known) {
                    return known.text() == warning.text();
                }))
                warnings.push_back(warning);
    return warnings;
}

}  // namespace specula
