#include "tools/sweep/sweep_plan.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/sample_layers.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/sweep/axis.hpp"

namespace specula {

namespace {

constexpr std::size_t most_geometries = 100'000;
constexpr std::size_t most_rows = 1'000'000;
constexpr double clear_of_antennas_m = 0.03;  ///< nearer than this the patch's own field acts
constexpr double degree = pi / 180.0;

/// A text that describes an axis, and where it stands.
struct AxisText {
    std::string text;
    Refusal refuse;
};

std::vector<double> values_of(const AxisText& axis, const AxisRules& rules, double to_si) {
    std::vector<double> values = read_axis(axis.text, rules, axis.refuse);
    for (double& value : values) value *= to_si;
    return values;
}

/// Finds axes in the arguments first, then in the sweep file.
class AxisSource {
  public:
    AxisSource(std::optional<Section> file) : file_(std::move(file)) {}

    std::optional<AxisText> find(const std::string& option, const std::string& argument,
                                 const std::string& key) {
        const bool in_file = file_ && file_->has(key);
        const std::string written = in_file ? file_->text(key) : "";
        if (!argument.empty())
            return AxisText{
                argument, [=](const std::string& problem, const std::string& remedy) {
                    throw InputError(format("{} = {}: {}; {}", option, argument, problem, remedy));
                }};
        if (!in_file) return {};
        return AxisText{
            written, [file = *file_, key](const std::string& problem, const std::string& remedy) {
                file.fail(key, problem, remedy);
            }};
    }

  private:
    std::optional<Section> file_;
};

/// One of `known`, or a refusal that names the nearest.
std::size_t choice_of(const std::string& word, const std::vector<std::string>& known,
                      const Refusal& refuse) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
        const std::string near = nearest_word(word, known);
        refuse(format("no such choice as \"{}\"", word),
               near.empty() ? "use " + quoted_list(known) : "did you mean " + near + "?");
    }
    return static_cast<std::size_t>(found - known.begin());
}

/// What the scene itself tilts, and by how much.
void read_scene_tilt(const std::filesystem::path& scene_file, SweepPlan& plan) {
    Section geometry = Section::read(scene_file).section("geometry");
    const Tilting tilting{
        .sensor = geometry.choice("tilted", {"sensor", "sample"}, "sensor") == "sensor",
        .elevation =
            geometry.choice("tilt_plane", {"azimuth", "elevation"}, "azimuth") == "elevation"};
    const Pose::Tilt& tilt = tilting.sensor ? plan.scene.pose.sensor : plan.scene.pose.sample;
    plan.tiltings = {tilting};
    plan.tilts_rad = {tilting.elevation ? tilt.about_x_rad : tilt.about_y_rad};
}

void read_tiltings(AxisSource& source, const SweepAxes& axes, SweepPlan& plan) {
    std::vector<bool> sensors{plan.tiltings[0].sensor}, elevations{plan.tiltings[0].elevation};
    if (const auto axis = source.find("--tilted", axes.tilted, "tilted")) {
        sensors.clear();
        for (const std::string& word : read_words(axis->text, axis->refuse))
            sensors.push_back(choice_of(word, {"sample", "sensor"}, axis->refuse) == 1);
    }
    if (const auto axis = source.find("--tilt-plane", axes.tilt_plane, "tilt_plane")) {
        elevations.clear();
        for (const std::string& word : read_words(axis->text, axis->refuse))
            elevations.push_back(choice_of(word, {"azimuth", "elevation"}, axis->refuse) == 1);
    }
    plan.tiltings.clear();
    for (const bool sensor : sensors)
        for (const bool elevation : elevations)
            if (const Tilting tilting{sensor, elevation};
                std::find(plan.tiltings.begin(), plan.tiltings.end(), tilting) ==
                plan.tiltings.end())
                plan.tiltings.push_back(tilting);
}

void read_geometry(AxisSource& source, const SweepAxes& axes, SweepPlan& plan) {
    if (const auto axis = source.find("--tilt", axes.tilt, "tilt_deg"))
        plan.tilts_rad = values_of(*axis, {"deg", -85.0, 85.0}, degree);
    if (const auto axis = source.find("--height", axes.height, "height_mm")) {
        plan.heights_m = values_of(*axis, {"mm", 0.0, 1e5, true}, 1e-3);
        for (const double height_m : plan.heights_m)
            if (const std::string blind = blind_reason(plan.scene.radar, height_m); !blind.empty())
                axis->refuse(format("{:g} mm {}", height_m * 1e3, blind),
                             "choose heights the radar sees, or another radar");
    }
    if (const auto axis = source.find("--size", axes.size, "size_mm")) {
        if (plan.scene.sample.mesh)
            axis->refuse("the sample is a mesh, whose size is in its file", "remove the sizes");
        plan.sizes_m.clear();
        for (const double size_m : values_of(*axis, {"mm", 0.0, 1e4, true}, 1e-3))
            plan.sizes_m.push_back({size_m, size_m});
    }
    if (const auto axis = source.find("--freq", axes.frequency, "freq_ghz")) {
        plan.frequencies_hz = values_of(*axis, {"GHz", 1.0, 1000.0}, 1e9);
        const auto& f = plan.frequencies_hz;
        for (std::size_t i = 2; i < f.size(); ++i)
            if (std::abs(f[i] - 2.0 * f[i - 1] + f[i - 2]) > 1.0)
                axis->refuse("the steps between frequencies differ", "write one first:last:step");
    }
    if (const auto axis = source.find("--plot", axes.plot, "plot")) {
        std::vector<std::string> known;
        for (const PlottedLevel& level : plotted_levels()) known.push_back(level.column);
        plan.plotted = choice_of(axis->text, known, axis->refuse);
    }
}

/// The products of materials, thicknesses and roughnesses; what is not given stays the scene's.
void read_specimens(const SweepAxes& axes, const Catalogue& catalogue, SweepPlan& plan) {
    AxisSource arguments({});
    const auto material = arguments.find("--material", axes.material, "");
    const auto thickness = arguments.find("--thickness", axes.thickness, "");
    const auto roughness = arguments.find("--roughness", axes.roughness, "");
    const auto correlation = arguments.find("--correlation", axes.correlation, "");
    if (!material && !thickness && !roughness && !correlation) return;
    Sample usual = plan.scene.sample;
    for (const auto& axis : {material, thickness, roughness, correlation})
        if (axis && !usual.layers.empty() && !(material && thickness))
            axis->refuse("the scene's sample has layers",
                         "give --material and --thickness, or edit the layers in a scene file");
    if (material) usual.layers.clear();
    std::vector<std::string> materials{usual.material};
    std::vector<double> thicknesses_m{usual.thickness_m}, roughnesses_m{usual.roughness_m};
    std::vector<double> correlations_m{usual.correlation_m};
    if (material) {
        materials = read_words(material->text, material->refuse);
        for (const std::string& name : materials)
            choice_of(name, catalogue.materials.names(), material->refuse);
    }
    if (thickness) thicknesses_m = values_of(*thickness, {"mm", 0.0, 1e3, true}, 1e-3);
    if (roughness) roughnesses_m = values_of(*roughness, {"um", 0.0, 2e3}, 1e-6);
    if (correlation) correlations_m = values_of(*correlation, {"mm", 0.01, 1e2}, 1e-3);
    plan.specimens.clear();
    for (const std::string& name : materials)
        for (const double thickness_m : thicknesses_m)
            for (const double roughness_m : roughnesses_m)
                for (const double correlation_m : correlations_m) {
                    Specimen specimen{name, usual};
                    Sample& sample = specimen.sample;
                    sample.material = name;
                    sample.thickness_m = thickness_m;
                    sample.roughness_m = roughness_m;
                    sample.correlation_m = correlation_m;
                    if (thickness) specimen.label += format(", {:g} mm", thickness_m * 1e3);
                    if (roughness)
                        specimen.label += format(", rms {:g} \u00b5m", roughness_m * 1e6);
                    if (correlation)
                        specimen.label += format(", over {:g} mm", correlation_m * 1e3);
                    plan.specimens.push_back(std::move(specimen));
                }
}

void read_file_specimens(Section& file, const Catalogue& catalogue, SweepPlan& plan) {
    for (Section& section : file.sections("specimen")) {
        Specimen specimen{"", plan.scene.sample};
        Sample& sample = specimen.sample;
        sample.layers.clear();
        const std::string label = section.text("label", "");
        read_matter(section, catalogue, sample);
        section.finish();
        specimen.label = label.empty() ? sample.title() : label;
        if (plan.specimens.size() >= 1000)
            section.fail("material", "is specimen 1001", "describe at most 1000");
        plan.specimens.push_back(std::move(specimen));
    }
}

void check_extent(const SweepPlan& plan) {
    if (plan.n_geometries() > most_geometries || plan.n_rows() > most_rows)
        throw InputError(
            format("sweep: {} geometries and {} rows are too many; use larger steps: "
                   "at most {} and {}",
                   plan.n_geometries(), plan.n_rows(), most_geometries, most_rows));
}

/// No corner of a tilted sample may come up to the antennas.
void check_clearance(const SweepPlan& plan) {
    for (const Tilting& tilting : plan.tiltings)
        for (const double tilt_rad : plan.tilts_rad)
            for (const auto& size_m : plan.sizes_m)
                for (const double height_m : plan.heights_m) {
                    if (tilting.sensor) continue;
                    Pose pose = plan.scene.pose;
                    pose.sample = {};
                    (tilting.elevation ? pose.sample.about_x_rad : pose.sample.about_y_rad) =
                        tilt_rad;
                    const Placement place = sample_placement(pose);
                    double top_m = 0.0;
                    for (const double x : {-0.5, 0.5})
                        for (const double y : {-0.5, 0.5})
                            top_m = std::max(top_m,
                                             place.point({x * size_m[0], y * size_m[1], 0.0}).z());
                    if (top_m > height_m - clear_of_antennas_m)
                        throw InputError(format(
                            "sweep: a sample of {:g} mm tilted by {:g} deg reaches up to {:.0f} "
                            "mm, and the antennas are at {:g} mm; keep {:g} mm between them",
                            std::max(size_m[0], size_m[1]) * 1e3, tilt_rad / degree, top_m * 1e3,
                            height_m * 1e3, clear_of_antennas_m * 1e3));
                }
}

}  // namespace

std::string Tilting::title() const {
    return format("{} tilted in {}", sensor ? "sensor" : "sample",
                  elevation ? "elevation" : "azimuth");
}

const std::vector<PlottedLevel>& plotted_levels() {
    static const std::vector<PlottedLevel> levels{
        {"received_dbm", "received power (dBm)"},
        {"over_mirror_db", "level over an infinite mirror (dB)"},
        {"over_untilted_db", "level over the untilted sample (dB)"},
        {"over_nominal_db", "level over that at the scene's height (dB)"}};
    return levels;
}

SweepPlan read_sweep_plan(const std::filesystem::path& file, const SweepAxes& axes,
                          const Catalogue& catalogue) {
    Section root = Section::read(file);
    SweepPlan plan;
    plan.name = file.stem().string();
    plan.source = root.source();
    std::optional<Section> sweep_file;
    std::filesystem::path scene_file = file;
    if (root.has("scene")) {
        sweep_file = root;
        plan.title = root.text("title");
        scene_file = file.parent_path() / root.text("scene");
        if (!std::filesystem::exists(scene_file))
            root.fail("scene", "no such file", "give a path relative to this file");
    }
    plan.scene = read_scene(scene_file, catalogue);
    plan.heights_m = {plan.scene.pose.height_m};
    plan.sizes_m = {{plan.scene.sample.face.size_x_m, plan.scene.sample.face.size_y_m}};
    read_scene_tilt(scene_file, plan);
    AxisSource source(sweep_file);
    read_tiltings(source, axes, plan);
    read_geometry(source, axes, plan);
    if (sweep_file) {
        read_file_specimens(*sweep_file, catalogue, plan);
        sweep_file->finish();
    }
    if (plan.specimens.empty()) plan.specimens = {{plan.scene.sample.title(), plan.scene.sample}};
    read_specimens(axes, catalogue, plan);
    if (plan.title.empty()) plan.title = "Sweep of " + plan.name;
    check_extent(plan);
    check_clearance(plan);
    return plan;
}

}  // namespace specula
