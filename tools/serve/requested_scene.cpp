#include "tools/serve/requested_scene.hpp"

#include "scenes/scene_text.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

double slope_mhz_us(const Radar& radar) {
    return radar.chirp.slope_hz_s / hz_s_per_mhz_us;
}

/// What of the request is not in the scene file.
std::string remarks(const SceneRequest& request, const Radar& of_file) {
    std::string text;
    if (request.slope_mhz_us != slope_mhz_us(of_file))
        text += format("# Not in here: chirp slope {:g} MHz/us.\n", request.slope_mhz_us);
    if (request.noise_figure_db != of_file.receiver.noise_figure_db)
        text += format("# Not in here: noise figure {:g} dB.\n", request.noise_figure_db);
    if (!request.leakage)
        text += "# Not in here: no leakage.\n";
    else if (request.leakage_db != 0.0)
        text += format("# Not in here: leakage {:+g} dB.\n", request.leakage_db);
    if (!text.empty()) text += "# They are the radar's: put them into a radar file of your own.\n";
    if (request.session != 0.0)
        text += format("# Session {:g} of the page adds its mounting errors and its room.\n",
                       request.session);
    return text;
}

void set_board(const SceneRequest& request, Scene& scene) {
    Radar& radar = scene.radar;
    radar.receiver.noise_figure_db = request.noise_figure_db;
    if (!request.leakage) radar.leakage.clear();
    for (Leakage& leak : radar.leakage) leak.level_dbm += request.leakage_db;
    if (request.slope_mhz_us == slope_mhz_us(radar)) return;
    radar.chirp.slope_hz_s = request.slope_mhz_us * hz_s_per_mhz_us;
    if (const auto breach = limit_breach(radar.limits, radar.chirp, radar.receiver))
        throw FieldError("slope_mhz_us", breach->problem, breach->remedy);
    const std::string blind = blind_reason(radar, scene.pose.height_m);
    if (!blind.empty())
        throw FieldError("height_mm", format("{:g} mm {}", request.height_mm, blind),
                         "change the height or the slope");
}

}  // namespace

std::string scene_toml(const SceneRequest& request, const Radar& of_file) {
    return format(
        "# A scene of the page of specula serve.\n{}"
        "radar = \"{}\"\n\n"
        "[sample]\nmaterial     = \"{}\"\nsize_mm      = [{:.10g}, {:.10g}]\n"
        "thickness_mm = {:.10g}\nbow_mm       = {:.10g}\nroughness_um = {:.10g}\n"
        "correlation_length_mm = {:.10g}\n\n"
        "[geometry]\nheight_mm  = {:.10g}\ntilt_deg   = {:.10g}\n"
        "tilt_plane = \"{}\"\ntilted     = \"{}\"\n",
        remarks(request, of_file), request.radar, request.material, request.size_mm,
        request.size_mm, request.thickness_mm, request.bow_mm, request.roughness_um,
        request.correlation_mm, request.height_mm, request.tilt_deg, request.tilt_plane,
        request.tilted);
}

Scene requested_scene(const SceneRequest& request, const Catalogue& catalogue,
                      const KnownNames& known) {
    const std::string text = scene_toml(request, *known.radar(request.radar));
    Scene scene = read_scene_text(text, "scene", catalogue);
    set_board(request, scene);
    return scene;
}

SceneRequest request_of_file(const std::filesystem::path& file, const Catalogue& catalogue) {
    constexpr double to_mm = 1e3, to_um = 1e6, to_deg = 180.0 / pi;
    const Scene scene = read_scene(file, catalogue);
    Section geometry = Section::read(file).section("geometry");
    SceneRequest request;
    request.radar = scene.radar.name;
    request.slope_mhz_us = slope_mhz_us(scene.radar);
    request.noise_figure_db = scene.radar.receiver.noise_figure_db;
    request.material = scene.sample.material;
    request.size_mm = scene.sample.face.size_x_m * to_mm;
    request.thickness_mm = scene.sample.thickness_m * to_mm;
    request.bow_mm = scene.sample.face.bow_m * to_mm;
    request.roughness_um = scene.sample.roughness_m * to_um;
    request.correlation_mm = scene.sample.correlation_m * to_mm;
    request.height_mm = scene.pose.height_m * to_mm;
    request.tilted = geometry.choice("tilted", {"sensor", "sample"}, "sensor");
    request.tilt_plane = geometry.choice("tilt_plane", {"azimuth", "elevation"}, "azimuth");
    const Pose::Tilt& tilt = request.tilted == "sensor" ? scene.pose.sensor : scene.pose.sample;
    request.tilt_deg =
        to_deg * (request.tilt_plane == "azimuth" ? tilt.about_y_rad : tilt.about_x_rad);
    return request;
}

}  // namespace specula
