#pragma once

#include "scenes/catalogue.hpp"
#include "scenes/motion.hpp"
#include "scenes/pose.hpp"
#include "scenes/sample.hpp"
#include "scenes/scene_object.hpp"
#include "scenes/solver.hpp"

namespace specula {

/// One measurement: a radar, a sample, how they lie to each other, and what else is about.
struct Scene {
    Radar radar;
    Sample sample;
    Pose pose;
    Solver solver{};
    std::vector<SceneObject> objects{};
    bool sample_is_watertight = false;    ///< a closed mesh
    std::vector<std::string> warnings{};  ///< what reading it found odd

    static constexpr std::size_t most_objects = 64;
    Motion motion{};  ///< of the sample while the frame is recorded
};

/// Reads a scene file (keys: scenes/README.md) and refuses what cannot be.
Scene read_scene(const std::filesystem::path& file, const Catalogue& catalogue);

/// What of the materials in it is not known to hold at the radar's frequencies.
std::vector<BandWarning> band_warnings(const Scene& scene, const Library& library);

/// Reads [geometry] with every key in it.
Pose read_pose(Section section);

/// The first reason why this radar cannot see a face at this height, empty when it can: too far for
/// the chirp's sampling, or so near that it shares the first bins with leakage.
std::string blind_reason(const Radar& radar, double height_m);

}  // namespace specula
