#include "tools/serve/chirp_answer.hpp"

#include <algorithm>
#include <cmath>

#include "sim/channel/reflector.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/limits.hpp"
#include "sim/link_budget.hpp"
#include "sim/mirror_foot.hpp"

namespace specula {

namespace {

constexpr double to_mm = 1e3;
constexpr double to_deg = 180.0 / pi;

/// A number for the page, which draws four digits of it.
float brief(double value) {
    return static_cast<float>(value);
}

FloatJson codes_json(const AdcFrame& frame) {
    FloatJson rows = FloatJson::array();
    const auto n = static_cast<std::size_t>(frame.n_samples);
    for (std::size_t rx = 0; rx < static_cast<std::size_t>(frame.n_rx); ++rx) {
        const auto begin = frame.codes.begin() + static_cast<std::ptrdiff_t>(rx * n);
        rows.push_back(std::vector<int>(begin, begin + static_cast<std::ptrdiff_t>(n)));
    }
    return rows;
}

FloatJson profile_json(const PageChirp& chirp, const std::vector<float>& profile) {
    const Radar& radar = chirp.scene.radar;
    const double height_m = chirp.scene.pose.height_m;
    return {{"lsb", profile},
            {"bin_mm", brief(radar.chirp.bin_m() * to_mm)},
            {"height_bin", brief(radar.chirp.bin_of(height_m))},
            {"mirror_lsb", brief(mirror_budget(radar, height_m).amplitude_lsb)}};
}

/// The models know one chirp only; another one makes other numbers of the same scene.
bool is_known_chirp(const Radar& radar, const Experiment& experiment) {
    return radar.name == experiment.radar.name &&
           radar.chirp.slope_hz_s == experiment.radar.chirp.slope_hz_s;
}

FloatJson answer_json(const Rung& rung, const std::vector<float>& profile) {
    const RungAnswer answer = ask(rung, profile);
    return {{"name", rung.recipe->name},
            {"features", answer.features},
            {"probability", answer.probability},
            {"max_logit", answer.max_logit},
            {"energy", answer.energy},
            {"distance", std::sqrt(answer.distance_squared)},
            {"familiar_distance", std::sqrt(rung.model.monitor->suspicious_squared)},
            {"is_familiar", answer.is_familiar}};
}

FloatJson models_json(const PageChirp& chirp, const RungSet& models, const Experiment& experiment,
                      const std::vector<float>& profile) {
    FloatJson answers = FloatJson::array();
    if (!is_known_chirp(chirp.scene.radar, experiment)) return answers;
    for (const Rung& rung : models.rungs) answers.push_back(answer_json(rung, profile));
    return answers;
}

FloatJson foot_json(const Scene& scene) {
    const MirrorFoot foot =
        mirror_foot(scene.pose, scene.sample.face, scene.radar.chirp.centre_hz());
    return {{"x_mm", brief(foot.x_m * to_mm)},
            {"y_mm", brief(foot.y_m * to_mm)},
            {"range_mm", brief(foot.range_m * to_mm)},
            {"fresnel_mm", brief(foot.fresnel_radius_m * to_mm)},
            {"critical_mm", brief(foot.critical_size_m * to_mm)},
            {"margin", brief(foot.margin(scene.sample.face))}};
}

/// How the recording differs from what the controls say.
FloatJson placement_json(const PageChirp& chirp) {
    const Truth& truth = chirp.truth;
    const Pose& asked = chirp.scene.pose;
    return {{"height_mm", brief((truth.height_m - asked.height_m) * to_mm)},
            {"tilt_x_deg", brief((truth.sample_tilt_x_rad - asked.sample.about_x_rad) * to_deg)},
            {"tilt_y_deg", brief((truth.sample_tilt_y_rad - asked.sample.about_y_rad) * to_deg)},
            {"offset_x_mm", brief(truth.offset_x_m * to_mm)},
            {"offset_y_mm", brief(truth.offset_y_m * to_mm)},
            {"yaw_deg", brief(truth.yaw_rad * to_deg)},
            {"gain_db", brief(truth.gain_db)}};
}

/// What the sample's layers reflect at the foot's angle of incidence, 57 to 64 GHz.
FloatJson slab_json(const Scene& scene, const Library& materials) {
    constexpr double first_hz = 57e9, step_hz = 0.1e9, faintest = 1e-4;
    constexpr int n = 71;
    const Reflector reflector = reflector_of(scene.sample, materials);
    std::vector<float> level_db;
    for (int i = 0; i < n; ++i) {
        const Reflection r = stack_reflection(reflector(first_hz + i * step_hz), 1.0);
        level_db.push_back(brief(20.0 * std::log10(std::max(std::abs(r.te), faintest))));
    }
    const FrequencyBand band = scene.radar.chirp.band();
    return {{"first_ghz", brief(first_hz * 1e-9)},
            {"step_ghz", brief(step_hz * 1e-9)},
            {"over_mirror_db", level_db},
            {"chirp_ghz", {brief(band.min_hz * 1e-9), brief(band.max_hz * 1e-9)}}};
}

FloatJson warnings_json(const PageChirp& chirp, const Library& materials) {
    std::vector<std::string> warnings = chirp.scene.warnings;
    for (const std::string& limit : optics_limits(chirp.scene, materials))
        warnings.push_back(limit);
    for (const BandWarning& warning : band_warnings(chirp.scene, materials))
        warnings.push_back(warning.text());
    if (chirp.is_weak)
        warnings.push_back(
            "the echo is 15 dB or more below that of a wide sheet: optics may be off by 1.5 dB");
    return warnings;
}

}  // namespace

FloatJson chirp_answer(const PageChirp& chirp, const RungSet& models, const Experiment& experiment,
                       const Library& materials) {
    const std::vector<float> profile = whole_profile(chirp.frame.view());
    return {{"adc", codes_json(chirp.frame)},
            {"full_scale_lsb", brief(chirp.scene.radar.adc_full_scale_lsb())},
            {"profile", profile_json(chirp, profile)},
            {"models", models_json(chirp, models, experiment, profile)},
            {"foot", foot_json(chirp.scene)},
            {"placement", placement_json(chirp)},
            {"slab", slab_json(chirp.scene, materials)},
            {"warnings", warnings_json(chirp, materials)}};
}

std::string chirp_csv(const PageChirp& chirp) {
    const AdcFrame& frame = chirp.frame;
    const Chirp& ramp = chirp.scene.radar.chirp;
    std::string text = "time_us,frequency_ghz";
    for (int rx = 0; rx < frame.n_rx; ++rx) text += format(",rx{}_lsb", rx);
    text += '\n';
    for (int n = 0; n < frame.n_samples; ++n) {
        constexpr double to_us = 1e6, to_ghz = 1e-9;
        text += format("{:.6g},{:.8g}", (n + ramp.skip_samples) / ramp.sample_rate_hz * to_us,
                       ramp.frequency_hz(n) * to_ghz);
        for (int rx = 0; rx < frame.n_rx; ++rx)
            text += format(",{}", frame.codes[static_cast<std::size_t>(rx * frame.n_samples + n)]);
        text += '\n';
    }
    return text;
}

}  // namespace specula
