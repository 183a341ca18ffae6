#include "tools/serve/page_bench.hpp"

#include <algorithm>

#include "sim/core/version.hpp"
#include "sim/limits.hpp"
#include "sim/simulate.hpp"

namespace specula {

namespace {

/// What the scene alone tells of its frame.
Truth truth_of(const Scene& scene) {
    Truth truth;
    const Pose& pose = scene.pose;
    truth.height_m = truth.nominal_height_m = pose.height_m;
    truth.sensor_tilt_x_rad = pose.sensor.about_x_rad;
    truth.sensor_tilt_y_rad = pose.sensor.about_y_rad;
    truth.sample_tilt_x_rad = pose.sample.about_x_rad;
    truth.sample_tilt_y_rad = pose.sample.about_y_rad;
    truth.size_x_m = scene.sample.face.size_x_m;
    truth.size_y_m = scene.sample.face.size_y_m;
    truth.thickness_m = scene.sample.thickness_m;
    truth.bow_m = scene.sample.face.bow_m;
    truth.roughness_m = scene.sample.roughness_m;
    truth.correlation_m = scene.sample.correlation_m;
    return truth;
}

PageChirp bench_drawing(Scene scene, const SceneRequest& request, const Library& materials) {
    PageChirp chirp{.scene = std::move(scene), .frame = {}, .truth = {}};
    const Channel echo = echo_channel(chirp.scene, materials);
    const auto seed = static_cast<std::uint64_t>(request.frame);
    Stream noise({.seed = seed, .purpose = "thermal noise"});
    FrameState state;
    state.draw.seed = seed;
    chirp.frame = record(chirp.scene, echo, noise, state);
    chirp.is_weak = !echo_limits(chirp.scene, materials, echo).empty();
    chirp.truth = truth_of(chirp.scene);
    return chirp;
}

/// The scene's sample as the only piece of its class.
SampleLaw law_of(const Sample& sample) {
    SampleLaw law;
    law.name = sample.material;
    law.nominal = sample;
    law.thickness_m = sample.thickness_m;
    law.bow_m = sample.face.bow_m;
    law.roughness_m = sample.roughness_m;
    law.correlation_m = sample.correlation_m;
    return law;
}

/// Its number keys the random numbers of the training sessions.
Condition condition_of(const SceneRequest& request, const Pose& pose, const Condition& training) {
    const bool sensor = request.tilted == "sensor";
    const bool elevation = request.tilt_plane == "elevation";
    const Pose::Tilt& tilt = sensor ? pose.sensor : pose.sample;
    Condition condition;
    condition.name = "page";
    condition.number = training.number;
    condition.heights_m = {pose.height_m};
    condition.tilts_rad = {elevation ? tilt.about_x_rad : tilt.about_y_rad};
    condition.tilts_sensor = sensor;
    condition.elevation = elevation;
    condition.sessions = static_cast<int>(request.session);
    condition.frames = static_cast<int>(request.frame) + 1;
    return condition;
}

PageChirp session_chirp(Scene scene, const SceneRequest& request, const Experiment& experiment,
                        const Library& materials) {
    Population population = experiment.population;
    const auto names = population.class_names();
    const auto found = std::find(names.begin(), names.end(), request.material);
    const auto label = found == names.end() ? 0 : found - names.begin();
    population.classes[static_cast<std::size_t>(label)] = law_of(scene.sample);
    const Bench bench{.radar = scene.radar,
                      .population = population,
                      .materials = materials,
                      .nominal_height_m = experiment.nominal_height_m,
                      .seed = experiment.seed,
                      .solver = scene.solver};
    const Condition condition = condition_of(request, scene.pose, experiment.training);
    const SessionFrames frames = simulate_session(
        bench, condition, {.label = static_cast<int>(label), .session = condition.sessions - 1});
    const Radar& radar = bench.radar;  // the scene's, which moves below
    AdcFrame frame{.n_chirps = radar.chirps_per_frame,
                   .n_rx = static_cast<int>(radar.rx.size()),
                   .n_samples = radar.chirp.n_samples,
                   .codes = {}};
    PageChirp chirp{.scene = std::move(scene),
                    .frame = std::move(frame),
                    .truth = frames.truth.back(),
                    .is_weak = frames.is_weak};
    const auto n_codes = static_cast<std::ptrdiff_t>(frames.adc.size() / frames.truth.size());
    chirp.frame.codes.assign(frames.adc.end() - n_codes, frames.adc.end());
    return chirp;
}

}  // namespace

Experiment page_experiment(const Catalogue& catalogue) {
    Experiment experiment = read_experiment(catalogue.experiment_file("paper"), catalogue);
    for (SampleLaw& law : experiment.population.classes) {
        law.permittivity_factor = 1.0;
        law.loss_factor = 1.0;
    }
    return experiment;
}

PageChirp simulate_request(const SceneRequest& request, const Experiment& experiment,
                           const Catalogue& catalogue, const KnownNames& known) {
    Scene scene = requested_scene(request, catalogue, known);
    return request.session == 0.0
               ? bench_drawing(std::move(scene), request, catalogue.materials)
               : session_chirp(std::move(scene), request, experiment, catalogue.materials);
}

Dataset dataset_of(const PageChirp& chirp, const SceneRequest& request,
                   const std::string& scene_text) {
    Dataset dataset;
    dataset.origin = {.condition = "serve",
                      .experiment = scene_text,
                      .seed = static_cast<std::uint64_t>(request.frame),
                      .version = program_version,
                      .radar = chirp.scene.radar.name,
                      .bin_m = chirp.scene.radar.chirp.bin_m(),
                      .recipe = {}};
    dataset.class_names = {chirp.scene.sample.title()};
    dataset.n_chirps = chirp.frame.n_chirps;
    dataset.n_rx = chirp.frame.n_rx;
    dataset.n_samples = chirp.frame.n_samples;
    dataset.adc = chirp.frame.codes;
    dataset.truth = {chirp.truth};
    dataset.truth.front().label = 0;
    return dataset;
}

}  // namespace specula
