#include "tools/serve/scene_request.hpp"

#include "tests/check.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/serve/project_names.hpp"
#include "tools/serve/page_bench.hpp"
#include "tools/serve/page_description.hpp"
#include "tools/serve/requested_scene.hpp"

namespace specula {
namespace {

FieldError refusal(const std::string& text) {
    try {
        requested_scene(read_request(parse_json(text), known()), catalogue(), known());
    } catch (const FieldError& error) {
        return error;
    }
    return {"", "taken", ""};
}

TEST_CASE("a board sees the heights that the page is told, and no millimetre more", "[serve]") {
    const Experiment experiment = page_experiment(catalogue());
    const FloatJson page = page_description({.catalogue = catalogue(),
                                             .known = known(),
                                             .experiment = experiment,
                                             .models = RungSet{},
                                             .lessons = {}});
    REQUIRE(page["radars"].size() == known().radars.size());
    for (const FloatJson& radar : page["radars"]) {
        const auto sees = [&](float height_mm) {
            return blind_reason(*known().radar(radar["name"]), 1e-3 * height_mm).empty();
        };
        INFO(radar.dump());
        const float least_mm = radar["heights_mm"][0], most_mm = radar["heights_mm"][1];
        CHECK(sees(least_mm));
        CHECK(sees(most_mm));
        CHECK(!sees(least_mm - 1));
        CHECK(!sees(most_mm + 1));
    }
}

TEST_CASE("an empty request is the usual scene, and every request reads back as itself",
          "[serve]") {
    const SceneRequest usual = read_request(parse_json("{}"), known());
    CHECK(usual.material == "aluminium");
    CHECK(usual.slope_mhz_us == Approx(150.0).epsilon(1e-12));
    const FloatJson json = request_json(usual);
    CHECK(request_json(read_request(json, known())) == json);
}

TEST_CASE("each number is refused beyond its range, with the range and its unit", "[serve]") {
    for (const NumberField& field : number_fields) {
        for (const double beyond : {field.min - 1.0, field.max + 1.0}) {
            const FieldError error =
                refusal("{\"" + std::string(field.key) + "\": " + std::to_string(beyond) + "}");
            CHECK(error.field() == field.key);
            CHECK(error.remedy().find(field.unit) != std::string::npos);
            CHECK(error.remedy().find("use ") == 0);
        }
        CHECK(refusal("{\"" + std::string(field.key) + "\": null}").field() == field.key);
        CHECK(refusal("{\"" + std::string(field.key) + "\": \"7\"}").field() == field.key);
    }
    CHECK(refusal("{\"frame\": 1.5}").remedy().find("whole") != std::string::npos);
}

TEST_CASE("unknown names are refused and the nearest known one is named", "[serve]") {
    CHECK(refusal(R"({"material": "plexiglas"})").remedy() == "did you mean \"plexiglass\"?");
    CHECK(refusal(R"({"hight_mm": 4})").remedy() == "did you mean \"height_mm\"?");
    CHECK(refusal(R"({"radar": "/etc/passwd"})").field() == "radar");
    CHECK(refusal(R"({"leakage": 0})").field() == "leakage");
}

TEST_CASE("what is no object of plain values is no request", "[serve]") {
    for (const char* text :
         {"", "[]", "1", "{", "{\"a\":}", "null", "{\"height_mm\":1e999}", "\xff\xfe"})
        CHECK(refusal(text).field() == "body");
    CHECK(refusal(std::string(60'000, '[')).field() == "body");
    CHECK(
        refusal("{\"size_mm\":" + std::string(1000, '[') + std::string(1000, ']') + "}").field() ==
        "body");
}

TEST_CASE("a chirp that the chip cannot make is refused with the chip's limit", "[serve]") {
    CHECK(refusal(R"({"slope_mhz_us": 120})").field().empty());
    CHECK(refusal(R"({"slope_mhz_us": 390})").field() == "slope_mhz_us");
    CHECK_THROWS(requested_scene(
        read_request(parse_json(R"({"roughness_um": 900, "thickness_mm": 0.2})"), known()),
        catalogue(), known()));
}

}  // namespace
}  // namespace specula
