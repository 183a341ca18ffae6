#include <cmath>
#include <cstdio>
#include <map>

#include "scenes/scene.hpp"
#include "scenes/ti_config.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/link_budget.hpp"
#include "sim/scene_target.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/show_material.hpp"
#include "tools/specula/show_radar.hpp"
#include "tools/study/experiment.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr double usual_height_m = 0.45;  ///< where a radar is shown that no scene places

void show_dataset(const fs::path& file) {
    const Dataset dataset = read_dataset(file);
    std::printf("%s: %zu frames x %d chirps x %d RX x %d samples\n", file.c_str(),
                dataset.n_frames(), dataset.n_chirps, dataset.n_rx, dataset.n_samples);
    std::printf("condition %s, radar %s, range bin %.4g cm, seed %llu, version %s\n",
                dataset.origin.condition.c_str(), dataset.origin.radar.c_str(),
                dataset.origin.bin_m * 100.0, static_cast<unsigned long long>(dataset.origin.seed),
                dataset.origin.version.c_str());
    std::printf("fingerprint %s\n\n", fingerprint(dataset).c_str());
    std::map<std::string, std::size_t> frames_of;
    for (const Truth& truth : dataset.truth) ++frames_of[dataset.class_names.at(truth.label)];
    for (const auto& [name, n] : frames_of) std::printf("%-20s %8zu frames\n", name.c_str(), n);
    std::printf("\n%-20s %12s %12s %12s  %s\n", "truth", "least", "mean", "most", "unit");
    for (const TruthColumn& column : truth_columns) {
        double least = INFINITY, most = -INFINITY, sum = 0.0;
        for (const Truth& truth : dataset.truth) {
            least = std::min(least, truth.*column.member);
            most = std::max(most, truth.*column.member);
            sum += truth.*column.member;
        }
        std::printf("%-20s %12.5g %12.5g %12.5g  %s\n", column.name, least,
                    sum / static_cast<double>(dataset.n_frames()), most, column.unit);
    }
}

void show_tilt(const char* what, const Pose::Tilt& tilt) {
    if (tilt.about_x_rad == 0.0 && tilt.about_y_rad == 0.0) return;
    std::printf("%s tilted by %.4g deg in azimuth, %.4g deg in elevation\n", what,
                tilt.about_y_rad * 180.0 / pi, tilt.about_x_rad * 180.0 / pi);
}

/// What a piece is made of and how large it is.
void show_matter(const Sample& sample, const char* how_opaque) {
    if (sample.mesh)
        std::printf("%s, %zu triangles, %.4g x %.4g mm seen along z, ", sample.title().c_str(),
                    sample.mesh->triangles.size(), sample.face.size_x_m * 1e3,
                    sample.face.size_y_m * 1e3);
    else
        std::printf("%s, %.4g x %.4g mm, ", sample.title().c_str(), sample.face.size_x_m * 1e3,
                    sample.face.size_y_m * 1e3);
    if (sample.mesh && sample.backing == sample.material)
        std::printf("solid%s\n", how_opaque);
    else
        std::printf("%.4g mm thick, backed by %s%s\n", sample.thickness_m * 1e3,
                    sample.backing.c_str(), how_opaque);
    std::printf("bow %.4g mm, roughness %.4g um rms, correlation length %.4g mm, piece %llu\n",
                sample.face.bow_m * 1e3, sample.roughness_m * 1e6, sample.correlation_m * 1e3,
                static_cast<unsigned long long>(sample.piece));
    for (const SampleLayer& layer : sample.layers)
        std::printf("  %-18s %8.4g mm, roughness %.4g um rms, correlation length %.4g mm\n",
                    layer.material.c_str(), layer.thickness_m * 1e3, layer.roughness_m * 1e6,
                    layer.correlation_m * 1e3);
}

void show_objects(const Scene& scene, const Library& materials) {
    const auto reflectors = reflectors_of(scene, materials);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        const Vector3 at_mm = 1e3 * object.own_placement.shift_m;
        const bool opaque =
            is_opaque(object.matter, reflectors[i + 1], scene.radar.chirp.centre_hz());
        std::printf("%s at (%.4g, %.4g, %.4g) mm, fixed to the %s: ", object.name.c_str(),
                    at_mm.x(), at_mm.y(), at_mm.z(), object.fixed_to_sample ? "sample" : "room");
        show_matter(object.matter, opaque ? ", opaque" : ", lets waves through");
    }
}

void show_scene(const Scene& scene, const Library& materials) {
    show_matter(scene.sample, "");
    show_objects(scene, materials);
    for (const std::string& warning : scene.warnings) std::printf("warning: %s\n", warning.c_str());
    for (const BandWarning& warning : band_warnings(scene, materials))
        std::printf("extrapolated: %s\n", warning.text().c_str());
    std::printf("the radar %.4g mm above it\n", scene.pose.height_m * 1e3);
    show_tilt("sensor", scene.pose.sensor);
    show_tilt("sample", scene.pose.sample);
    std::printf("accuracy %.4g dB, up to %d bounces\n\n", scene.solver.accuracy_db,
                scene.solver.max_bounces);
    show_radar(scene.radar, scene.pose.height_m);
}

void show_experiment(const Experiment& experiment) {
    std::printf("%s\n%s\n\n", experiment.title.c_str(), experiment.question.c_str());
    std::printf("%d worlds, %zu classes, radar %s\n\n", experiment.full.worlds,
                experiment.population.classes.size(), experiment.radar.name.c_str());
    const auto line = [](const Condition& c) {
        std::printf("%-14s %-52s %3d sessions x %d frames per class\n", c.name.c_str(),
                    c.title.c_str(), c.sessions_per_class(), c.frames);
    };
    line(experiment.training);
    for (const Condition& condition : experiment.conditions) line(condition);
}

}  // namespace

void show_command(const ShowArguments& arguments, const Catalogue& catalogue) {
    const std::string& what = arguments.what;
    const fs::path path = what;
    const auto show = [&](const Material& material) { show_material(material, arguments.figure); };
    if (path.extension() == ".h5") return show_dataset(path);
    const auto show_warned = [](const Radar& radar) {
        for (const std::string& warning : radar.warnings) say_warning(warning);
        show_radar(radar, usual_height_m);
    };
    if (is_ti_config(path)) return show_warned(catalogue.radar_of_file(path));
    if (path.extension() == ".toml") {
        Section section = Section::read(path);
        if (section.has("training")) return show_experiment(read_experiment(path, catalogue));
        if (section.has("chirp")) return show_warned(read_radar(path));
        if (section.has("model")) return show(read_material(path, catalogue.materials.lookup()));
        return show_scene(read_scene(path, catalogue), catalogue.materials);
    }
    if (const Material* material = catalogue.materials.find(what)) return show(*material);
    const auto radars = catalogue.radar_names(), experiments = catalogue.experiment_names();
    if (std::find(radars.begin(), radars.end(), what) != radars.end())
        return show_warned(catalogue.radar_called(what));
    if (std::find(experiments.begin(), experiments.end(), what) != experiments.end())
        return show_experiment(read_experiment(catalogue.experiment_file(what), catalogue));
    std::vector<std::string> known = catalogue.materials.names();
    known.insert(known.end(), radars.begin(), radars.end());
    known.insert(known.end(), experiments.begin(), experiments.end());
    const std::string near = nearest_word(what, known);
    throw InputError(format("\"{}\": nothing of that name; {}", what,
                            near.empty() ? "see specula list materials, list radars and list "
                                           "experiments, or name a .toml, .cfg or .h5 file"
                                         : "did you mean " + near + "?"));
}

}  // namespace specula
