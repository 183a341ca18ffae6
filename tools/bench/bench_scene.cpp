#include "tools/bench/bench_scene.hpp"

#include "sim/channel/layer_path.hpp"
#include "sim/scene_target.hpp"
#include "sim/simulate.hpp"

namespace specula {

BenchScene::BenchScene(const Catalogue& known)
    : catalogue(known), experiment(read_experiment(known.experiment_file("paper"), known)) {}

Scene BenchScene::plate(const std::string& material, double tilt_rad) const {
    Scene scene{.radar = experiment.radar, .sample = {}, .pose = {}, .solver = experiment.solver};
    for (const SampleLaw& law : experiment.population.classes)
        if (law.nominal.material == material) scene.sample = law.nominal;
    scene.sample.material = material;
    scene.pose.height_m = experiment.nominal_height_m;
    scene.pose.sample.about_y_rad = tilt_rad;
    return scene;
}

OpenScene::OpenScene(const Scene& scene, const Library& materials)
    : comb(comb_of(scene.radar.chirp)),
      reflectors(reflectors_of(scene, materials)),
      target(target_of(scene, reflectors)),
      antennas(antennas_of(scene.radar, radar_placement(scene.pose))),
      settings{.highest_hz = comb.last_hz(),
               .accuracy_db = scene.solver.accuracy_db,
               .max_bounces = scene.solver.max_bounces,
               .lowest_hz = comb.first_hz,
               .layer_path_m = layer_path_m(reflectors[0](comb.at(comb.n / 2)))} {}

Mesh sphere_mesh(const BenchSphere& sphere) {
    const Placement placement{.rotation = Rotation::Identity(),
                              .shift_m = Vector3(0.0, 0.0, -sphere.distance_m)};
    return triangulate(SphereSurface{sphere.radius_m, placement},
                       Cells{sphere.n_around, sphere.n_around});
}

}  // namespace specula
