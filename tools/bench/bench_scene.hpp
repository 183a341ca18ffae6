#pragma once

#include "scenes/scene.hpp"
#include "sim/signal/dechirp.hpp"
#include "sim/trace/trace.hpp"
#include "tools/bench/bench.hpp"
#include "tools/study/experiment.hpp"

namespace specula {

/// What all parts of the bench look at: the paper's experiment, its radar and its 30 cm plates.
struct BenchScene {
    explicit BenchScene(const Catalogue& catalogue);

    const Catalogue& catalogue;
    Experiment experiment;

    /// A plate of the experiment's size at its height.
    Scene plate(const std::string& material, double tilt_rad) const;
    Bench sessions() const { return bench_of(experiment, catalogue.materials); }
};

/// A scene taken apart as the simulator does it, so that each stage can be run alone.
struct OpenScene {
    OpenScene(const Scene& scene, const Library& materials);

    FrequencyComb comb;
    std::vector<Reflector> reflectors;
    Target target;
    AntennaSet antennas;
    TraceSettings settings;
};

/// A sphere of triangles with its middle below the radar at the origin.
struct BenchSphere {
    double radius_m = 0.1;
    double distance_m = 0.45;
    std::uint32_t n_around = 2;  ///< triangles: twice this squared
};
Mesh sphere_mesh(const BenchSphere& sphere);

}  // namespace specula
