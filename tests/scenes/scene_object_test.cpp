#include "scenes/scene.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/mesh_text.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

const std::string least_scene =
    "radar = 'iwrl6432boost'\n"                                  // 1
    "[sample]\nmaterial = 'plexiglass'\nsize_mm = [300, 200]\n"  // 2 to 4
    "thickness_mm = 5\n[geometry]\nheight_mm = 450\n";           // 5 to 7
const std::string table =
    "[[object]]\nname = 'table'\nmaterial = 'aluminium'\n"                   // 8 to 10
    "size_mm = [500, 500]\nthickness_mm = 20\nposition_mm = [0, 0, -50]\n";  // 11 to 13

/// A folder with a mesh in it, for scenes that name one.
struct MeshFolder : MadeUpFolder {
    MeshFolder() { with("body.stl", tetrahedron_files().at("text.stl")); }
    Scene read(const std::string& text) const {
        return read_scene(with("x.toml", text), catalogue());
    }
    std::string error_of(const std::string& text) const {
        const auto file = with("x.toml", text);
        const std::string message = message_of([&] { return read_scene(file, catalogue()); });
        const auto at = message.find("x.toml:");
        return at == std::string::npos ? message : message.substr(at);
    }
};

bool holds(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
        return text.find(part) != std::string::npos;
    });
}

TEST_CASE("an object stands in the room, or is carried by the sample", "[scene][object]") {
    const MeshFolder folder;
    const std::string tilted =
        least_scene + "tilt_deg = 30\ntilted = 'sample'\noffset_mm = [10, 0]\n";
    const Scene still = folder.read(tilted + table);
    REQUIRE(still.objects.size() == 1);
    CHECK(still.objects[0].name == "table");
    CHECK(still.objects[0].matter.material == "aluminium");
    CHECK((still.objects[0].placement(still.pose).shift_m - Vector3(0, 0, -0.05)).norm() < 1e-15);
    const Scene carried = folder.read(tilted + table + "fixed_to = 'sample'\n");
    const Placement sample = sample_placement(carried.pose);
    CHECK(
        (carried.objects[0].placement(carried.pose).shift_m - sample.point({0, 0, -0.05})).norm() <
        1e-15);
}

TEST_CASE("a rotation turns about x, then y, then z", "[scene][object]") {
    const MeshFolder folder;
    const Scene scene = folder.read(least_scene + table + "rotation_deg = [90, 90, 0]\n");
    // y goes to z by the first turn and on to x by the second.
    const Placement placed = scene.objects[0].placement(scene.pose);
    CHECK((placed.direction(Vector3::UnitY()) - Vector3::UnitX()).norm() < 1e-12);
}

TEST_CASE("a mesh is in its own unit, solid without a thickness, a wall with one",
          "[scene][object]") {
    const MeshFolder folder;
    const std::string mesh = "[[object]]\nshape = 'mesh'\nfile = 'body.stl'\nmaterial = 'wood'\n";
    const Sample solid = folder.read(least_scene + mesh + "unit = 'mm'\n").objects[0].matter;
    REQUIRE(solid.mesh);
    CHECK(solid.face.size_y_m == Approx(0.02));
    CHECK(solid.backing == "wood");
    const Sample wall =
        folder.read(least_scene + mesh + "unit = 'cm'\nthickness_mm = 2\n").objects[0].matter;
    CHECK(wall.face.size_y_m == Approx(0.2));
    CHECK(wall.backing == "air");
    CHECK(wall.thickness_m == Approx(0.002));
    CHECK(folder.error_of(least_scene + mesh).find("object.unit") != std::string::npos);
    CHECK(folder.error_of(least_scene + mesh + "unit = 'mm'\nbacking = 'metal'\n") ==
          "x.toml:13: object.backing = \"metal\": lies behind a body that is solid; give it a "
          "thickness, or remove the backing");
    CHECK(folder.error_of(least_scene + edited(mesh, "body", "nobody") + "unit = 'mm'\n") ==
          "x.toml:10: object.file = \"nobody.stl\": no such file beside this one; give a path "
          "relative to this file");
}

TEST_CASE("the sample may be a mesh too, turned in place", "[scene][object]") {
    const MeshFolder folder;
    const std::string text = edited(least_scene, "size_mm = [300, 200]\nthickness_mm = 5",
                                    "shape = 'mesh'\nfile = 'body.stl'\nunit = 'mm'\n"
                                    "rotation_deg = [0, 0, 90]");
    const Sample sample = folder.read(text).sample;
    REQUIRE(sample.mesh);
    CHECK((sample.mesh->vertices_m[2] - Vector3(0.0, 0.01, 0.0)).norm() < 1e-12);
    CHECK(sample.backing == "plexiglass");
}

TEST_CASE("what touches an antenna is refused, what comes near it is warned of",
          "[scene][object]") {
    const MeshFolder folder;
    const std::string height = least_scene + edited(table, "-50", "447");
    CHECK(
        folder.error_of(height).find(
            "x.toml:8: object = [{...}]: table comes within 3 mm of an antenna; move the object or "
            "the radar") == 0);
    const Scene near = folder.read(least_scene + edited(table, "-50", "430"));
    CHECK(holds(near.warnings, "table comes within 20 mm of an antenna; below 30 mm"));
    CHECK(folder.read(least_scene + table).warnings.empty());
    // The rim, 750 mm from the pivot as the radar is, swings up to it: 3-4-5 triangle.
    const std::string swung =
        least_scene + "tilt_deg = 36.87\ntilted = 'sample'\npivot_mm = [600, 0, 0]\n";
    CHECK(folder.error_of(swung).find("x.toml:7: geometry.height_mm = 450: the sample comes "
                                      "within") == 0);
}

TEST_CASE("what lies behind the antennas, too far, or around them is warned of",
          "[scene][object]") {
    const MeshFolder folder;
    CHECK(holds(folder.read(least_scene + edited(table, "-50", "600")).warnings,
                "table lies behind the antennas"));
    CHECK(holds(folder.read(least_scene + edited(table, "-50", "-3000")).warnings,
                "table is beyond the farthest range"));
    const std::string room =
        "[[object]]\nname = 'room'\nshape = 'box'\nsize_m = [4, 4, 3]\nposition_m = [0, 0, 2]\n"
        "material = 'concrete'\n";
    CHECK(holds(folder.read(least_scene + room).warnings, "the radar stands inside room"));
}

TEST_CASE("roughness no less than the thickness is refused", "[scene][object]") {
    const MeshFolder folder;
    const std::string rough =
        edited(least_scene, "thickness_mm = 5", "thickness_um = 50\nroughness_um = 50");
    CHECK(folder.error_of(rough) ==
          "x.toml:6: sample.roughness_um = 50: is no less than the thickness, 0.05 mm; the rms "
          "height of a face stays below the layer's thickness");
}

TEST_CASE("opacity is what the file says, and cannot be denied to what has a backing",
          "[scene][object]") {
    const MeshFolder folder;
    CHECK(folder.read(least_scene + table).objects[0].matter.opaque == std::nullopt);
    CHECK(folder.read(least_scene + table + "opaque = true\n").objects[0].matter.opaque == true);
    CHECK(folder.error_of(least_scene + table + "backing = 'metal'\nopaque = false\n")
              .find("object.opaque = false: what lies behind it in contact ends") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
