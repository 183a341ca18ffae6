#include "tools/serve/lesson.hpp"

#include <algorithm>

#include "materials/stack.hpp"
#include "sim/channel/reflector.hpp"
#include "sim/mirror_foot.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/serve/project_names.hpp"
#include "tools/serve/page_bench.hpp"

namespace specula {
namespace {

const Lesson& lesson(int number) {
    static const std::vector<Lesson> lessons = read_lessons(catalogue(), known());
    REQUIRE(lessons.size() == 6);
    return lessons[static_cast<std::size_t>(number - 1)];
}

SceneRequest changed(const Lesson& of, const FloatJson& set) {
    FloatJson request = request_json(of.scene);
    request.update(set);
    request.erase("model");
    return read_request(request, known());
}

Scene scene_of(const SceneRequest& request) {
    return requested_scene(request, catalogue(), known());
}

/// Mean over RX and chirp of the echo alone.
double level_db(const SceneRequest& request) {
    const Channel echo = echo_channel(scene_of(request), catalogue().materials);
    double sum = 0.0;
    for (const Complex& h : echo.h) sum += std::norm(h);
    return 10.0 * std::log10(sum / static_cast<double>(echo.h.size()));
}

double change_db(const Lesson& of, const FloatJson& set) {
    return level_db(changed(of, set)) - level_db(of.scene);
}

TEST_CASE("a plate under a tilted radar keeps its echo, and its foot in place", "[serve][lesson]") {
    CHECK(std::abs(change_db(lesson(1), {{"tilt_deg", 10}, {"tilted", "sensor"}})) < 1.5);
    CHECK(std::abs(change_db(lesson(1), {{"tilt_deg", 10}, {"tilted", "sample"}})) < 1.5);
    const Scene tilted = scene_of(changed(lesson(1), {{"tilt_deg", 10}, {"tilted", "sample"}}));
    const MirrorFoot foot = mirror_foot(tilted.pose, tilted.sample.face, 60e9);
    CHECK(std::hypot(foot.x_m, foot.y_m) == Approx(0.45 * std::sin(0.174533)).epsilon(1e-4));
    CHECK(foot.fresnel_radius_m == Approx(0.033).epsilon(0.02));  // the text's number
}

TEST_CASE("ten centimetres of height are two and a half bins and a few decibels",
          "[serve][lesson]") {
    const Scene scene = scene_of(lesson(2).scene);
    CHECK(scene.radar.chirp.bin_of(0.45) == Approx(11.5).margin(0.05));
    CHECK(scene.radar.chirp.bin_of(0.10) == Approx(2.55).margin(0.05));
    CHECK(change_db(lesson(2), {{"height_mm", 350}}) == Approx(2.4).margin(1.0));
}

TEST_CASE("ten degrees of the sample cost 15 cm its echo, 30 cm and a tilted radar nothing",
          "[serve][lesson]") {
    // Of ten degrees, with everything else as `set` says.
    const auto cost_db = [](FloatJson set) {
        const double level = level_db(changed(lesson(3), set));
        set["tilt_deg"] = 0;
        return level - level_db(changed(lesson(3), set));
    };
    CHECK(cost_db({{"tilt_deg", 10}}) < -6.0);
    CHECK(std::abs(cost_db({{"tilt_deg", 10}, {"size_mm", 300}})) < 1.0);
    CHECK(std::abs(cost_db({{"tilt_deg", 10}, {"tilted", "sensor"}})) < 1.0);
    const MirrorFoot foot =
        mirror_foot(scene_of(changed(lesson(3), {{"tilt_deg", 10}})).pose, Plate{0.15, 0.15}, 60e9);
    CHECK(foot.margin({0.15, 0.15}) < 0.0);
}

TEST_CASE("half a wave of plexiglass is all but invisible, three quarters are not",
          "[serve][lesson]") {
    CHECK(change_db(lesson(4), {{"thickness_mm", 1.55}}) < -20.0);  // "a hundred times as strong"
    CHECK(change_db(lesson(4), {{"thickness_mm", 4.65}}) < -6.0);
}

TEST_CASE("iron and aluminium differ by a hundredth of a decibel and by no code worth naming",
          "[serve][lesson]") {
    CHECK(std::abs(change_db(lesson(5), {{"material", "aluminium"}})) < 0.015);
    const auto codes = [](const char* metal) {
        const SceneRequest request = changed(lesson(5), {{"material", metal}, {"session", 0}});
        return simulate_request(request, page_experiment(catalogue()), catalogue(), known())
            .frame.codes;
    };
    const auto iron = codes("iron"), aluminium = codes("aluminium");
    int most = 0;
    for (std::size_t i = 0; i < iron.size(); ++i)
        most = std::max(most, std::abs(iron[i] - aluminium[i]));
    CHECK(most <= 2);  // 0.015 dB and 0.1 degrees of some 300 codes, and rounding
}

TEST_CASE("every lesson tells something to look for and something to try", "[serve][lesson]") {
    for (int number = 1; number <= 6; ++number) {
        CHECK(lesson(number).tries.size() >= 3);
        CHECK(lesson(number).name[0] == static_cast<char>('0' + number));
        CHECK(lesson(number).look_for.size() > 40);
    }
}

TEST_CASE("a lesson that the page could not follow is refused with its file", "[serve][lesson]") {
    const MadeUpFolder folder;
    const std::string good = project_file("scenes/lessons/1_a_plate_is_a_mirror.toml");
    const auto read = [&](const std::string& from, const std::string& to) {
        const auto file = folder.with("lesson.toml", edited(good, from, to));
        return message_of([&] { read_lesson(file, catalogue(), known()); });
    };
    CHECK(read("size_mm = 80:", "size_mm = 8:").find("size_mm") != std::string::npos);
    CHECK(read("size_mm = 80:", "syze_mm = 80:").find("did you mean \"size_mm\"?") !=
          std::string::npos);
    CHECK(read("size_mm = 80:", "model = oracle:").find("model") != std::string::npos);
    CHECK(read("Look for:", "Mind:").find("teaches nothing") != std::string::npos);
}

}  // namespace
}  // namespace specula
