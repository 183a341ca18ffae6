#include "scenes/sample_layers.hpp"

#include "scenes/scene.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

const std::string rusty =
    "radar = 'iwrl6432boost'\n"                                // 1
    "[sample]\n"                                               // 2
    "size_mm = [300, 300]\n"                                   // 3
    "[[sample.layer]]\n"                                       // 4
    "material = 'rust'\n"                                      // 5
    "thickness_um = 30\n"                                      // 6
    "roughness_um = 10\n"                                      // 7
    "[[sample.layer]]\nmaterial = 'iron'\nthickness_mm = 3\n"  // 8 to 10
    "[geometry]\nheight_mm = 450\n";

Sample sample_of(const std::string& text) {
    const MadeUpFolder folder;
    return read_scene(folder.with("x.toml", text), catalogue()).sample;
}

std::string problem(const std::string& text) {
    const MadeUpFolder folder;
    const std::string message =
        message_of([&] { return read_scene(folder.with("x.toml", text), catalogue()); });
    return message.substr(std::min(message.find("x.toml"), message.size()));
}

TEST_CASE("layers are read from the radar's side down, each with its own face", "[sample]") {
    const Sample sample = sample_of(rusty);
    REQUIRE(sample.layers.size() == 2);
    CHECK(sample.layers[0].material == "rust");
    CHECK(sample.layers[0].roughness_m == Approx(10e-6));
    CHECK(sample.layers[1].thickness_m == Approx(3e-3));
    CHECK(sample.layers[1].roughness_m == 0.0);
    CHECK(sample.title() == "rust on iron");
}

TEST_CASE("of a layered sample, thickness is that of all and the face that of the first",
          "[sample]") {
    const Sample sample = sample_of(rusty);
    CHECK(sample.material == "rust");
    CHECK(sample.thickness_m == Approx(3.03e-3));
    CHECK(sample.roughness_m == Approx(10e-6));
}

TEST_CASE("one layer is the sample that its keys describe without a layer", "[sample]") {
    const std::string keys = "material = 'wood'\nthickness_mm = 18\nroughness_um = 25\n";
    const std::string before = "radar = 'iwrl6432boost'\n[sample]\nsize_mm = [300, 300]\n";
    const std::string after = "[geometry]\nheight_mm = 450\n";
    const Sample plain = sample_of(before + keys + after);
    const Sample layered = sample_of(before + "[[sample.layer]]\n" + keys + after);
    CHECK(plain.layers.empty());
    REQUIRE(plain.all_layers().size() == 1);
    CHECK(plain.all_layers()[0].material == layered.layers[0].material);
    CHECK(plain.all_layers()[0].thickness_m == layered.layers[0].thickness_m);
    CHECK(plain.all_layers()[0].roughness_m == layered.layers[0].roughness_m);
    CHECK(plain.title() == "wood");
}

TEST_CASE("a material beside layers is refused, for it would be none of them", "[sample]") {
    CHECK(problem(edited(rusty, "size_mm", "material = 'wood'\nsize_mm")) ==
          "x.toml:3: sample.material = \"wood\": stands beside layers; "
          "give it in a [[sample.layer]], or remove the layers");
    CHECK(problem(edited(rusty, "size_mm", "thickness_mm = 3\nsize_mm"))
              .rfind("x.toml:3: sample.thickness_mm = 3: stands beside layers", 0) == 0);
    CHECK(problem(edited(rusty, "size_mm", "roughness_um = 3\nsize_mm"))
              .rfind("x.toml:3: sample.roughness_um = 3: stands beside layers", 0) == 0);
}

TEST_CASE("a layer's mistakes are refused where they stand", "[sample]") {
    CHECK(problem(edited(rusty, "thickness_um = 30", "thickness_um = 0"))
              .rfind("x.toml:6: sample.layer.thickness_um = 0: is out of range", 0) == 0);
    CHECK(problem(edited(rusty, "'rust'", "'trust'"))
              .rfind("x.toml:5: sample.layer.material = \"trust\": is not known; "
                     "did you mean \"rust\"?",
                     0) == 0);
    CHECK(problem(edited(rusty, "roughness_um = 10", "rougness_um = 10"))
              .rfind("x.toml:7: sample.layer.rougness_um = 10: is not a key of this table", 0) ==
          0);
}

TEST_CASE("sixteen layers are enough", "[sample]") {
    std::string many = "radar = 'iwrl6432boost'\n[sample]\nsize_mm = [300, 300]\n";
    for (int i = 0; i < 17; ++i) many += "[[sample.layer]]\nmaterial = 'wood'\nthickness_mm = 1\n";
    CHECK(problem(many + "[geometry]\nheight_mm = 450\n")
              .find("17 layers; describe 1 to 16 of them") != std::string::npos);
}

TEST_CASE("veneers run along the sample's grain or across it", "[sample]") {
    const std::string text =
        "radar = 'iwrl6432boost'\n[sample]\nsize_mm = [300, 300]\ngrain_deg = 30\n"
        "[[sample.layer]]\nmaterial = 'pine'\nthickness_mm = 2\n"
        "[[sample.layer]]\nmaterial = 'pine'\nthickness_mm = 2\ngrain = 'across'\n"
        "[geometry]\nheight_mm = 450\n";
    const Sample sample = sample_of(text);
    CHECK(sample.grain_rad == Approx(0.5235987755982988));
    CHECK_FALSE(sample.layers[0].turned);
    CHECK(sample.layers[1].turned);
    CHECK(problem(edited(text, "'across'", "'oblique'")).find("use \"along\" or \"across\"") !=
          std::string::npos);
}

TEST_CASE("every example scene can be read", "[sample]") {
    int n_layered = 0;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(SPECULA_SOURCE_DIR) / "scenes/examples")) {
        if (!is_description(entry.path())) continue;
        INFO(entry.path());
        const Scene scene = read_scene(entry.path(), catalogue());
        CHECK(band_warnings(scene, catalogue().materials).empty());
        if (!scene.sample.layers.empty()) ++n_layered;
    }
    CHECK(n_layered >= 3);
}

}  // namespace
}  // namespace specula
