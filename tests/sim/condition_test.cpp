#include "sim/condition.hpp"

#include <map>

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

Condition condition_in(const std::string& text) {
    Section section = Section::parse("name = \"c\"\ntitle = \"C\"\nframes = 2\n" + text, "c.toml");
    const Condition condition = read_condition(section, Radar{}, 0.45, 3);
    section.finish();
    return condition;
}

std::string condition_refusal(const std::string& text) {
    return message_of([&] { return condition_in(text); });
}

TEST_CASE("sessions run over all heights and, at each, over all tilts", "[sim]") {
    Condition condition;
    condition.heights_m = {0.35, 0.45, 0.55};
    condition.tilts_rad = {-0.1, 0.2};
    condition.sessions = 4;
    REQUIRE(condition.geometries() == 6);
    REQUIRE(condition.sessions_per_class() == 24);
    std::map<std::pair<double, double>, int> count;
    for (int session = 0; session < 24; ++session) {
        const Pose pose = condition.pose(session);
        ++count[{pose.height_m, pose.sensor.about_y_rad}];
        CHECK(pose.height_m == condition.heights_m[static_cast<std::size_t>(session / 8)]);
        CHECK(pose.sensor.about_y_rad ==
              condition.tilts_rad[static_cast<std::size_t>(session / 4 % 2)]);
        CHECK(pose.sensor.about_x_rad == 0.0);
        CHECK(pose.sample.about_x_rad == 0.0);
        CHECK(pose.sample.about_y_rad == 0.0);
    }
    CHECK(count.size() == 6);
    for (const auto& [geometry, sessions] : count) CHECK(sessions == 4);
}

TEST_CASE("the tilt goes to what is tilted, in the plane asked for", "[sim]") {
    Condition condition;
    condition.heights_m = {0.45};
    condition.tilts_rad = {0.3};
    condition.pivot_m = {0.0, 0.0, -0.1};
    for (const bool sensor : {true, false})
        for (const bool elevation : {true, false}) {
            condition.tilts_sensor = sensor;
            condition.elevation = elevation;
            const Pose pose = condition.pose(0);
            CHECK(pose.sensor.about_x_rad == (sensor && elevation ? 0.3 : 0.0));
            CHECK(pose.sensor.about_y_rad == (sensor && !elevation ? 0.3 : 0.0));
            CHECK(pose.sample.about_x_rad == (!sensor && elevation ? 0.3 : 0.0));
            CHECK(pose.sample.about_y_rad == (!sensor && !elevation ? 0.3 : 0.0));
            CHECK(pose.pivot_m == condition.pivot_m);
        }
}

TEST_CASE("a condition that says little is recorded straight down at the nominal height", "[sim]") {
    const Condition condition = condition_in("sessions = 4\n");
    CHECK(condition.number == 3);
    CHECK(condition.heights_m == std::vector<double>{0.45});
    CHECK(condition.tilts_rad == std::vector<double>{0.0});
    CHECK_FALSE(condition.new_samples);
    CHECK(condition.sessions == 4);
    CHECK(condition.frames == 2);
}

TEST_CASE("a condition's keys arrive where they belong", "[sim]") {
    const Condition condition = condition_in(
        "sessions = 1\nheight_mm = [350, 550]\ntilt_deg = [-10, 10]\ntilted = \"sample\"\n"
        "tilt_plane = \"elevation\"\npivot_mm = [1, 2, -30]\nsamples = \"new\"\n");
    REQUIRE(condition.heights_m.size() == 2);
    CHECK(condition.heights_m[0] == Approx(0.35));
    CHECK(condition.heights_m[1] == Approx(0.55));
    CHECK(condition.tilts_rad[1] == Approx(0.17453292519943295));
    CHECK_FALSE(condition.tilts_sensor);
    CHECK(condition.elevation);
    CHECK(condition.pivot_m.isApprox(Vector3(0.001, 0.002, -0.03)));
    CHECK(condition.new_samples);
}

TEST_CASE("what the radar cannot see or nobody can do is refused by line", "[sim]") {
    CHECK(contains(condition_refusal("sessions = 4\nheight_mm = [450, 50]\n"),
                   "c.toml:5: height_mm"));
    CHECK(contains(condition_refusal("sessions = 4\nheight_mm = [450, 50]\n"), "boards leak"));
    CHECK(
        contains(condition_refusal("sessions = 4\nheight_m = [5]\n"), "beyond the farthest range"));
    CHECK(
        contains(condition_refusal("sessions = 4\nheight_cm = [45, 5]\n"), "c.toml:5: height_cm"));
    CHECK(contains(condition_refusal("sessions = 4\ntilt_deg = [86]\n"), "c.toml:5: tilt_deg"));
    CHECK(contains(condition_refusal("sessions = 0\n"), "c.toml:4: sessions"));
    CHECK(contains(condition_refusal("sessions = 600\nheight_mm = [400, 500]\n"), "1200 sessions"));
    CHECK(contains(condition_refusal("sessions = 1\nsamples = \"other\"\n"), "samples"));
    CHECK(contains(condition_refusal("sessions = 1\ntilted = \"sensor\"\npivot_mm = [0, 0, 5]\n"),
                   "c.toml:6: pivot_mm"));
    CHECK(condition_refusal("sessions = 512\nheight_mm = [400, 500]\n") == "(no error)");
}

}  // namespace
}  // namespace specula
