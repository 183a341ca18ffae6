#include "scenes/scene.hpp"

#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

using namespace literals;

constexpr const char* least =
    "radar = 'iwrl6432boost'\n"  // 1
    "[sample]\n"                 // 2
    "material = 'plexiglass'\n"  // 3
    "size_mm = [300, 200]\n"     // 4
    "thickness_mm = 5\n"         // 5
    "[geometry]\n"               // 6
    "height_mm = 450\n";         // 7

Scene scene_in(const std::string& text) {
    const MadeUpFolder folder;
    return read_scene(folder.with("x.toml", text), catalogue());
}

/// What reading `text` says, without the folder of the file.
std::string scene_error(const std::string& text) {
    const MadeUpFolder folder;
    const auto file = folder.with("x.toml", text);
    const std::string message = message_of([&] { return read_scene(file, catalogue()); });
    const auto at = message.find("x.toml:");
    return at == std::string::npos ? message : message.substr(at);
}

std::string geometry_error(const std::string& lines) {
    return scene_error(edited(least, "height_mm = 450\n", lines));
}

TEST_CASE("a scene of its least keys is a flat, untilted sample in air", "[scene]") {
    const Scene scene = scene_in(least);
    CHECK(scene.radar.name == "iwrl6432boost");
    CHECK(scene.sample.material == "plexiglass");
    CHECK(scene.sample.face.size_x_m == Approx(0.3));
    CHECK(scene.sample.face.size_y_m == Approx(0.2));
    CHECK(scene.sample.face.bow_m == 0.0);
    CHECK(scene.sample.thickness_m == Approx(5.0_mm));
    CHECK(scene.sample.roughness_m == 0.0);
    CHECK(scene.sample.backing == "air");
    CHECK(scene.pose.height_m == Approx(450.0_mm));
    CHECK(scene.pose.sensor.about_x_rad == 0.0);
    CHECK(scene.pose.sensor.about_y_rad == 0.0);
    CHECK(scene.pose.sample.about_x_rad == 0.0);
    CHECK(scene.pose.sample.about_y_rad == 0.0);
    CHECK(scene.pose.pivot_m == Vector3::Zero());
    CHECK(scene.pose.offset_x_m == 0.0);
    CHECK(scene.pose.yaw_rad == 0.0);
}

TEST_CASE("azimuth tilts about y, elevation about x, and only what is said to be tilted",
          "[scene]") {
    const auto pose = [](const std::string& lines) { return scene_in(least + lines).pose; };
    CHECK(pose("tilt_deg = 10\n").sensor.about_y_rad == Approx(10.0_deg));
    CHECK(pose("tilt_deg = -10\ntilt_plane = 'elevation'\n").sensor.about_x_rad ==
          Approx(-10.0_deg));
    const Pose sample = pose("tilt_deg = 10\ntilted = 'sample'\npivot_mm = [150, 0, -5]\n");
    CHECK(sample.sample.about_y_rad == Approx(10.0_deg));
    CHECK(sample.sensor.about_y_rad == 0.0);
    CHECK((sample.pivot_m - Vector3(0.15, 0.0, -0.005)).norm() < 1e-15);
    const Pose placed = pose("offset_cm = [2, -1]\nyaw_deg = 45\n");
    CHECK(placed.offset_x_m == Approx(2.0_cm));
    CHECK(placed.offset_y_m == Approx(-1.0_cm));
    CHECK(placed.yaw_rad == Approx(45.0_deg));
}

TEST_CASE("every example reads", "[scene]") {
    int n_read = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECULA_SOURCE_DIR "/scenes/examples")) {
        if (entry.path().extension() != ".toml") continue;
        INFO(entry.path());
        CHECK_NOTHROW(read_scene(entry.path(), catalogue()));
        ++n_read;
    }
    CHECK(n_read >= 2);
}

TEST_CASE("a pose that cannot be is refused at its key and in its unit", "[scene]") {
    CHECK(geometry_error("height_mm = -3\n") ==
          "x.toml:7: geometry.height_mm = -3: is out of range; "
          "give a value above 0 mm and below 100000 mm");
    for (const char* value : {"95", "90", "-90", "85.001"})
        CHECK(geometry_error("height_mm = 450\ntilt_deg = " + std::string(value) + "\n") ==
              "x.toml:8: geometry.tilt_deg = " + std::string(value) +
                  ": is out of range; give a value at least -85 deg and at most 85 deg");
    CHECK(geometry_error("height_mm = 450\ntilt_deg = 85\n") == "(no error)");
    CHECK(geometry_error("height_cm = 45\ntilted = 'sensor'\npivot_cm = [0, 0, 0]\n") ==
          "x.toml:9: geometry.pivot_cm = [0, 0, 0]: a tilted sensor turns about its own phase "
          "centre; remove it, or write tilted = \"sample\"");
    CHECK(geometry_error("height_mm = 450\ntilt_plane = 'vertical'\n") ==
          "x.toml:8: geometry.tilt_plane = \"vertical\": is not known; "
          "use \"azimuth\" or \"elevation\"");
    CHECK(geometry_error("height = 450\n") ==
          "x.toml:7: geometry.height = 450: has no unit; "
          "write height_mm, height_m, height_cm or height_um");
    CHECK(geometry_error("height_mm = 450\noffset_mm = 3\n").find("give 2 numbers: [...]") !=
          std::string::npos);
}

TEST_CASE("a sample that cannot be is refused at its key", "[scene]") {
    CHECK(scene_error(edited(least, "thickness_mm = 5", "thickness_mm = 0")) ==
          "x.toml:5: sample.thickness_mm = 0: is out of range; "
          "give a value above 0 mm and below 1000 mm");
    CHECK(scene_error(edited(least, "[300, 200]", "[300, 0]")) ==
          "x.toml:4: sample.size_mm = [300, 0]: is out of range; "
          "give a value above 0 mm and below 10000 mm");
    CHECK(scene_error(edited(least, "plexiglass", "plexiglas"))
              .rfind("x.toml:3: sample.material = \"plexiglas\": is not known; "
                     "did you mean \"plexiglass\"?",
                     0) == 0);
    CHECK(scene_error(edited(least, "thickness_mm", "shape = 'dics'\nthickness_mm"))
              .rfind("x.toml:5: sample.shape = \"dics\": is not known; use \"plate\", ", 0) == 0);
    CHECK(scene_error(edited(least, "thickness_mm", "roughness_um = 2001\nthickness_mm"))
              .find("at most 2000 um") != std::string::npos);
    CHECK(scene_error(edited(least, "[sample]", "color = 'red'\n[sample]")) ==
          "x.toml:2: color = \"red\": is not a key of this file; remove it");
}

TEST_CASE("a height that the radar cannot see is refused, and the advice then works", "[scene]") {
    const std::string advice = "; choose a height of 118 to 2248 mm, or another radar";
    CHECK(geometry_error("height_m = 5\n") ==
          "x.toml:7: geometry.height_m = 5: is beyond the farthest range of the chirp of "
          "iwrl6432boost, 2.25 m" +
              advice);
    CHECK(geometry_error("height_cm = 500\n").rfind("x.toml:7: geometry.height_cm = 500: ", 0) ==
          0);
    CHECK(geometry_error("height_mm = 117\n") ==
          "x.toml:7: geometry.height_mm = 117: is bin 3.00 of the chirp of iwrl6432boost, among "
          "bins 0 to 2, where boards leak" +
              advice);
    CHECK(geometry_error("height_mm = 118\n") == "(no error)");
    CHECK(geometry_error("height_mm = 2248\n") == "(no error)");
    CHECK(blind_reason(scene_in(least).radar, 0.45).empty());
}

}  // namespace
}  // namespace specula
