#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scenes/scene.hpp"
#include "scenes/ti_config.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/limits.hpp"
#include "sim/link_budget.hpp"
#include "sim/mirror_foot.hpp"
#include "sim/scene_target.hpp"
#include "tools/console/console.hpp"
#include "tools/dataset/dataset_path.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/show_dataset.hpp"
#include "tools/specula/show_material.hpp"
#include "tools/specula/show_radar.hpp"
#include "tools/study/experiment.hpp"
#include "tools/sweep/sweep_table.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr double usual_height_m = 0.45;  ///< where a radar is shown that no scene places

void show_sweep(const fs::path& file) {
    const StoredSweep sweep = read_sweep_hdf5(file);
    std::printf("%s: %s, %zu rows\nradar %s, version %s\nspecimens: ", file.c_str(),
                sweep.title.c_str(), sweep.columns.front().values.size(), sweep.radar.c_str(),
                sweep.version.c_str());
    for (std::size_t i = 0; i < sweep.specimens.size(); ++i)
        std::printf("%s%s", i > 0 ? "; " : "", sweep.specimens[i].c_str());
    std::printf("\n\n%-20s %12s %12s  %-5s %s\n", "column", "least", "most", "unit", "meaning");
    for (const SweepColumn& column : sweep.columns) {
        const auto [least, most] = std::minmax_element(column.values.begin(), column.values.end());
        std::printf("%-20s %12.5g %12.5g  %-5s %s\n", column.name.c_str(), *least, *most,
                    column.unit.c_str(), column.meaning.c_str());
    }
}

void show_tilt(const char* what, const Pose::Tilt& tilt) {
    if (tilt.about_x_rad == 0.0 && tilt.about_y_rad == 0.0) return;
    std::printf("%s tilted by %.4g deg in azimuth, %.4g deg in elevation\n", what,
                tilt.about_y_rad * 180.0 / pi, tilt.about_x_rad * 180.0 / pi);
}

/// Why a tilt or a height changes the echo, or does not.
void show_foot(const Scene& scene) {
    const Chirp& chirp = scene.radar.chirp;
    const MirrorFoot foot = mirror_foot(scene.pose, scene.sample.face, chirp.centre_hz());
    const double margin = foot.margin(scene.sample.face);
    std::printf(
        "mirror's foot %.4g, %.4g mm from the centre of the face, Fresnel zone %.3g mm: %s\n",
        foot.x_m * 1e3, foot.y_m * 1e3, foot.fresnel_radius_m * 1e3,
        margin < -1.0  ? "it has left the sample"
        : margin < 1.0 ? "the rim cuts it"
                       : "well inside the sample");
    std::printf("  a sample of %.4g mm would just hold it; range %.5g mm, bin %.2f\n",
                foot.critical_size_m * 1e3, foot.range_m * 1e3, chirp.bin_of(foot.range_m));
    if (foot.divergence_db != 0.0)
        std::printf("  the bow alone changes the echo by %.2f dB\n", foot.divergence_db);
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
    for (const std::string& limit : optics_limits(scene, materials))
        std::printf("warning: %s\n", limit.c_str());
    for (const BandWarning& warning : band_warnings(scene, materials))
        std::printf("extrapolated: %s\n", warning.text().c_str());
    std::printf("the radar %.4g mm above it\n", scene.pose.height_m * 1e3);
    show_tilt("sensor", scene.pose.sensor);
    show_tilt("sample", scene.pose.sample);
    if (!scene.sample.mesh) show_foot(scene);
    std::printf("accuracy %.4g dB, up to %d bounces\n\n", scene.solver.accuracy_db,
                scene.solver.max_bounces);
    show_radar(scene.radar, scene.pose.height_m);
}

void show_experiment(const Experiment& experiment) {
    std::printf("%s\n%s\n\n", experiment.title.c_str(), experiment.question.c_str());
    std::printf("%d worlds, %zu classes, radar %s\n\n", experiment.usual.worlds,
                experiment.population.classes.size(), experiment.radar.name.c_str());
    const auto line = [](const Condition& c) {
        std::printf("%-14s %-52s %3d sessions x %d frames per class\n", c.name.c_str(),
                    c.title.c_str(), c.sessions_per_class(), c.frames);
    };
    line(experiment.training);
    for (const Condition& condition : experiment.conditions) line(condition);
}

void show_plan(const SweepPlan& plan) {
    std::printf(
        "%s\n\n%zu rows: %zu specimens x %zu sizes x %zu ways to tilt x %zu heights x %zu "
        "tilts x %zu frequencies\n",
        plan.title.c_str(), plan.n_rows(), plan.specimens.size(), plan.sizes_m.size(),
        plan.tiltings.size(), plan.heights_m.size(), plan.tilts_rad.size(), plan.n_frequencies());
    for (const Specimen& specimen : plan.specimens)
        std::printf("  %-28s %8.4g mm, roughness %.4g um rms\n", specimen.label.c_str(),
                    specimen.sample.thickness_m * 1e3, specimen.sample.roughness_m * 1e6);
}

/// Refuses a name that is of another kind than the one written before it, as in "material
/// plexiglass".
void check_kind(const ShowArguments& arguments, const Catalogue& catalogue) {
    const std::vector<std::string> known =
        arguments.kind == "material" ? catalogue.materials.names()
        : arguments.kind == "radar"  ? catalogue.radar_names()
        : arguments.kind == "sweep"  ? catalogue.sweep_names()
                                     : catalogue.experiment_names();
    const bool is_file = !fs::path(arguments.what).extension().empty();
    if (is_file || std::find(known.begin(), known.end(), arguments.what) != known.end()) return;
    const std::string near = nearest_word(arguments.what, known);
    throw InputError(format(
        "\"{}\": no such {}; {}", arguments.what, arguments.kind,
        near.empty() ? "see specula list " + arguments.kind + "s" : "did you mean " + near + "?"));
}

}  // namespace

void show_command(const ShowArguments& arguments, const Catalogue& catalogue) {
    const std::string& what = arguments.what;
    if (!arguments.kind.empty()) check_kind(arguments, catalogue);
    const fs::path path = what;
    const auto show = [&](const Material& material) { show_material(material, arguments.figure); };
    if (fs::exists(path / "index.h5")) return show_dataset(dataset_file(path), arguments.figure);
    if (path.extension() == ".h5")
        return is_sweep_hdf5(path) ? show_sweep(path) : show_dataset(path, arguments.figure);
    const auto show_warned = [](const Radar& radar) {
        for (const std::string& warning : radar.warnings) say_warning(warning);
        show_radar(radar, usual_height_m);
    };
    if (is_ti_config(path)) return show_warned(catalogue.radar_of_file(path));
    if (path.extension() == ".toml") {
        Section section = Section::read(path);
        if (section.has("training")) return show_experiment(read_experiment(path, catalogue));
        if (section.has("chirp")) return show_warned(read_radar(path));
        if (section.has("scene")) return show_plan(read_sweep_plan(path, {}, catalogue));
        if (section.has("model")) return show(read_material(path, catalogue.materials.lookup()));
        return show_scene(read_scene(path, catalogue), catalogue.materials);
    }
    if (const Material* material = catalogue.materials.find(what)) return show(*material);
    const auto radars = catalogue.radar_names(), experiments = catalogue.experiment_names();
    if (std::find(radars.begin(), radars.end(), what) != radars.end())
        return show_warned(catalogue.radar_called(what));
    if (std::find(experiments.begin(), experiments.end(), what) != experiments.end())
        return show_experiment(read_experiment(catalogue.experiment_file(what), catalogue));
    const auto sweeps = catalogue.sweep_names();
    if (std::find(sweeps.begin(), sweeps.end(), what) != sweeps.end())
        return show_plan(read_sweep_plan(catalogue.sweep_file(what), {}, catalogue));
    std::vector<std::string> known = catalogue.materials.names();
    known.insert(known.end(), radars.begin(), radars.end());
    known.insert(known.end(), experiments.begin(), experiments.end());
    known.insert(known.end(), sweeps.begin(), sweeps.end());
    const std::string near = nearest_word(what, known);
    throw InputError(format("\"{}\": nothing of that name; {}", what,
                            near.empty() ? "see specula list materials, list radars and list "
                                           "experiments, or name a .toml, .cfg or .h5 file"
                                         : "did you mean " + near + "?"));
}

}  // namespace specula
