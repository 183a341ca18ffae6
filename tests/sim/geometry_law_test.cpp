#include "sim/geometry_law.hpp"

#include <set>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/small_bench.hpp"

namespace specula {
namespace {

GeometryLaw geometry(const std::string& keys) {
    return read_geometry(Section::parse(keys, "geometry.toml"), SmallBench().radar, 0.45);
}

TEST_CASE("without laws a session stands straight at the nominal height", "[sim]") {
    const Pose pose = geometry("").pose({});
    CHECK(pose.height_m == 0.45);
    CHECK(pose.sensor.about_x_rad == 0.0);
    CHECK(pose.sample.about_y_rad == 0.0);
    CHECK(pose.yaw_rad == 0.0);
}

TEST_CASE("each key of a geometry moves what it names", "[sim]") {
    const Pose pose = geometry(
                          "height_mm = 500\nsensor_tilt_x_deg = 1\nsensor_tilt_y_deg = 2\n"
                          "sample_tilt_x_deg = 3\nsample_tilt_y_deg = 4\noffset_x_mm = 5\n"
                          "offset_y_mm = 6\nyaw_deg = 7\npivot_mm = [8, 9, 10]\n")
                          .pose({});
    CHECK(pose.height_m == 0.5);
    CHECK(pose.sensor.about_x_rad == Approx(1.0 * pi / 180.0));
    CHECK(pose.sensor.about_y_rad == Approx(2.0 * pi / 180.0));
    CHECK(pose.sample.about_x_rad == Approx(3.0 * pi / 180.0));
    CHECK(pose.sample.about_y_rad == Approx(4.0 * pi / 180.0));
    CHECK(pose.offset_x_m == Approx(0.005));
    CHECK(pose.offset_y_m == Approx(0.006));
    CHECK(pose.yaw_rad == Approx(7.0 * pi / 180.0));
    CHECK(pose.pivot_m.z() == Approx(0.01));
}

TEST_CASE("grids run through all their pairs, the first key fastest", "[sim]") {
    const GeometryLaw law =
        geometry("height_mm = { grid = [300, 400, 500] }\nyaw_deg = { grid = [0, 90] }\n");
    std::set<std::pair<double, double>> seen;
    for (std::uint32_t i = 0; i < 6; ++i) {
        const Pose pose = law.pose({.index = i, .n = 6});
        CHECK(pose.height_m == Approx(0.3 + 0.1 * (i % 3)));
        seen.insert({pose.height_m, pose.yaw_rad});
    }
    CHECK(seen.size() == 6);
}

TEST_CASE("quasi-random heights and tilts cover the square evenly", "[sim]") {
    const GeometryLaw law = geometry(
        "height_mm = { uniform = [300, 600], sampling = \"quasi\" }\n"
        "sensor_tilt_x_deg = { uniform = [-10, 10], sampling = \"quasi\" }\n");
    std::set<std::pair<int, int>> cells;  // 4 by 4
    for (std::uint32_t i = 0; i < 16; ++i) {
        const Pose pose = law.pose({.seed = 3, .group = 2, .index = i, .n = 16});
        cells.insert({static_cast<int>((pose.height_m - 0.3) / 0.075),
                      static_cast<int>((pose.sensor.about_x_rad * 180.0 / pi + 10.0) / 5.0)});
    }
    CHECK(cells.size() == 16);
}

TEST_CASE("a law that can draw what is impossible is refused by key and line", "[sim]") {
    CHECK(
        message_of([] {
            geometry("\nheight_mm = { normal = [50, 20] }");
        }).rfind("geometry.toml:2: height_mm = {...}: may be drawn as -0.0", 0) ==
        0);
    CHECK(message_of([] {
              geometry("height_m = { uniform = [1, 99] }");
          }).find("m, which is beyond the farthest range") != std::string::npos);
    CHECK(message_of([] {
              geometry("yaw_deg = { uniform = [0, 9], sampling = \"sobol\" }");
          }).find("use \"random\", \"stratified\" or \"quasi\"") != std::string::npos);
    CHECK(message_of([] {
              geometry("yaw_deg = { grid = [0, 9], sampling = \"quasi\" }");
          }).find("keep the grid alone") != std::string::npos);
    CHECK(message_of([] {
              geometry("yaw_deg = { uniform = [9, 0], sampling = \"quasi\" }");
          }).rfind("geometry.toml:1: yaw_deg.uniform", 0) == 0);
    CHECK(message_of([] {
              geometry("\n\nyaw_deg = { unifrom = [0, 9], sampling = \"quasi\" }");
          }).rfind("geometry.toml:3: yaw_deg.unifrom = [0, 9]: is not a value or a law; did you mean "
                   "uniform?", 0) == 0);
    CHECK(message_of([] {
              geometry("\n\nyaw_deg = { uniform = [9, 0], sampling = \"quasi\" }");
          }).rfind("geometry.toml:3: yaw_deg.uniform = [9, 0]: runs backwards", 0) == 0);
}

TEST_CASE("a dataset's sessions stand where the law says, and stay on a piece", "[sim]") {
    const SmallBench small;
    Condition condition = straight_down(0);
    condition.new_samples = true;
    condition.sessions = 4;
    condition.sessions_per_piece = 2;
    condition.frames = 1;
    condition.geometry_law =
        geometry("height_mm = { uniform = [400, 500], sampling = \"stratified\" }");
    condition.geometry_law->n_sessions = 8;
    const Dataset dataset = generate(small.bench(), condition, 2, 2);
    std::map<int, std::set<int>> strata;  // class -> eighths of the range
    std::set<int> pieces;
    for (const Truth& truth : dataset.truth) {
        strata[truth.label].insert(static_cast<int>((truth.nominal_height_m - 0.4) / 0.0125));
        CHECK(std::abs(truth.height_m - truth.nominal_height_m) < 0.02);  // the session's error
        pieces.insert(truth.sample);
    }
    for (const auto& [label, eighths] : strata) CHECK(eighths.size() == 8);
    CHECK(pieces.size() == 5 * 2 * 2);  // classes, worlds, pieces
}

}  // namespace
}  // namespace specula
