#include "tools/serve/level_curve.hpp"

#include <chrono>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/mirror_foot.hpp"
#include "tools/sweep/sweep.hpp"

namespace specula {

namespace {

constexpr double degree = pi / 180.0;
constexpr double metres_per_mm = 1e-3;

struct AxisPoints {
    double first, last, step;
};
constexpr AxisPoints tilts_deg{-20.0, 20.0, 0.5};
constexpr AxisPoints heights_mm{250.0, 650.0, 5.0};
constexpr std::size_t points_between_looks = 8;  ///< at the clock

const AxisPoints& points_of(CurveAxis axis) {
    return axis == CurveAxis::tilt ? tilts_deg : heights_mm;
}

double tilt_of(const Pose& pose) {
    return pose.sensor.about_x_rad + pose.sensor.about_y_rad + pose.sample.about_x_rad +
           pose.sample.about_y_rad;
}

/// A sample's upper rim must stay clear of the antennas.
bool is_clear(const Scene& scene, const Pose& pose) {
    constexpr double clear_m = 0.05;
    const double tilt_rad = pose.sample.about_x_rad + pose.sample.about_y_rad;
    const double reach_m = 0.5 * scene.sample.face.size_x_m * std::abs(std::sin(tilt_rad));
    return reach_m < pose.height_m - clear_m;
}

Pose posed(const Scene& scene, const CurveRequest& request, double x) {
    Pose pose = scene.pose;
    if (request.axis == CurveAxis::height) {
        pose.height_m = x * metres_per_mm;
        return pose;
    }
    pose.sensor = pose.sample = {};
    Pose::Tilt& tilt = request.tilting.sensor ? pose.sensor : pose.sample;
    (request.tilting.elevation ? tilt.about_x_rad : tilt.about_y_rad) = x * degree;
    return pose;
}

/// The places of the whole axis that can be.
std::vector<double> possible_points(const Scene& scene, const CurveRequest& request) {
    const AxisPoints& points = points_of(request.axis);
    std::vector<double> possible;
    for (double x = points.first; x <= points.last; x += points.step) {
        const Pose pose = posed(scene, request, x);
        if (blind_reason(scene.radar, pose.height_m).empty() && is_clear(scene, pose))
            possible.push_back(x);
    }
    return possible;
}

/// Some neighbouring points as a sweep of their own, so that time can run out between.
void add_points(const Scene& scene, const CurveRequest& request, const Library& materials,
                std::span<const double> points, LevelCurve& curve) {
    SweepPlan plan;
    plan.scene = scene;
    plan.specimens = {{scene.sample.title(), scene.sample}};
    plan.sizes_m = {{scene.sample.face.size_x_m, scene.sample.face.size_y_m}};
    plan.tiltings = {request.tilting};
    plan.heights_m = {scene.pose.height_m};
    plan.tilts_rad = {tilt_of(scene.pose)};
    std::vector<double>& axis = request.axis == CurveAxis::tilt ? plan.tilts_rad : plan.heights_m;
    axis.clear();
    for (const double x : points)
        axis.push_back(x * (request.axis == CurveAxis::tilt ? degree : metres_per_mm));
    std::atomic<std::size_t> done{0};
    const Sweep sweep = run_sweep(plan, materials, 1, done);
    const double hz = scene.radar.chirp.centre_hz();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SweepRow& row = sweep.rows[i];
        const Pose pose = posed(scene, request, points[i]);
        const double level_db = request.axis == CurveAxis::tilt
                                    ? row.over_mirror_db
                                    : row.level_db + scene.radar.tx_power_dbm;
        curve.x.push_back(static_cast<float>(points[i]));
        curve.level_db.push_back(static_cast<float>(level_db));
        curve.foot_margin.push_back(
            static_cast<float>(mirror_foot(pose, scene.sample.face, hz).margin(scene.sample.face)));
    }
}

}  // namespace

LevelCurve level_curve(const Scene& scene, const CurveRequest& request, const Library& materials) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<double> points = possible_points(scene, request);
    LevelCurve curve;
    for (std::size_t first = 0; first < points.size(); first += points_between_looks) {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        if (request.stop || spent.count() > request.most_s) return {};
        const std::size_t n = std::min(points_between_looks, points.size() - first);
        add_points(scene, request, materials, std::span(points).subspan(first, n), curve);
    }
    return curve;
}

Tilting tilting_of(const SceneRequest& request) {
    return {.sensor = request.tilted == "sensor", .elevation = request.tilt_plane == "elevation"};
}

std::string sweep_command_line(const SceneRequest& request, CurveAxis axis) {
    const AxisPoints& points = points_of(axis);
    const std::string range = format("{:g}:{:g}:{:g}", points.first, points.last, points.step);
    if (axis == CurveAxis::height)
        return format("specula sweep specula_scene.toml --height {}", range);
    return format("specula sweep specula_scene.toml --tilt {} --tilted {} --tilt-plane {}", range,
                  request.tilted, request.tilt_plane);
}

}  // namespace specula
