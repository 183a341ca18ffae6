#include "tools/serve/level_curve.hpp"

#include <algorithm>
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
constexpr std::size_t coarse = 8;  ///< every eighth point comes first, then those between

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

struct CurvePoint {
    double x, level_db, foot_margin;
};

/// Some points, in ascending order, as a sweep of their own, so that time can run out between.
void add_points(const Scene& scene, const CurveRequest& request, const Library& materials,
                std::span<const double> points, std::vector<CurvePoint>& found) {
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
        found.push_back({points[i], level_db,
                         mirror_foot(pose, scene.sample.face, hz).margin(scene.sample.face)});
    }
}

/// Every `step`-th of the points from one on.
std::vector<double> every(const std::vector<double>& points, std::size_t from, std::size_t step) {
    std::vector<double> some;
    for (std::size_t i = from; i < points.size(); i += step) some.push_back(points[i]);
    return some;
}

LevelCurve as_curve(std::vector<CurvePoint> found) {
    std::sort(found.begin(), found.end(),
              [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
    LevelCurve curve;
    for (const CurvePoint& point : found) {
        curve.x.push_back(static_cast<float>(point.x));
        curve.level_db.push_back(static_cast<float>(point.level_db));
        curve.foot_margin.push_back(static_cast<float>(point.foot_margin));
    }
    return curve;
}

}  // namespace

LevelCurve level_curve(const Scene& scene, const CurveRequest& request, const Library& materials) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<double> points = possible_points(scene, request);
    std::vector<CurvePoint> found;
    std::vector<std::vector<double>> passes{every(points, 0, coarse)};
    for (std::size_t step = coarse; step > 1; step /= 2)
        passes.push_back(every(points, step / 2, step));
    for (const std::vector<double>& pass : passes)
        for (std::size_t first = 0; first < pass.size(); first += coarse) {
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
            const bool is_late = spent.count() > request.most_s && &pass != &passes.front();
            if (request.stop || is_late) return request.stop ? LevelCurve{} : as_curve(found);
            const std::size_t n = std::min(coarse, pass.size() - first);
            add_points(scene, request, materials, std::span(pass).subspan(first, n), found);
        }
    return as_curve(found);
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
