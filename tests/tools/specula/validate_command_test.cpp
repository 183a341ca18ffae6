#include <nlohmann/json.hpp>

#include "tests/check.hpp"
#include "tests/run_program.hpp"

// The command as its user meets it; what it computes is tested in tests/tools/validate.

namespace specula {
namespace {

const std::string good = R"({"id": "M01_x", "title": "air", "tolerance": {"abs": 1e-9},
 "points": [{"inp": {"eps": 4, "theta_deg": 0}, "expect": {"r_TE": -0.3333333333333}}]})";

Ended validated_in(const MadeUpFolder& folder, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"validate", "cases"});
    return specula_in(folder.path(), more);
}

TEST_CASE("validate ends with 0, 1, 2 or 3 for pass, fail, bad file and unknown kind",
          "[program][validate]") {
    const MadeUpFolder folder;
    folder.with("cases/a.json", good);
    CHECK(validated_in(folder).status == 0);
    folder.with("cases/b.json", edited(good, "M01_x", "Q17_x"));
    CHECK(validated_in(folder).status == 3);
    folder.with("cases/c.json", edited(good, "-0.333", "-0.334"));
    const Ended failed = validated_in(folder);
    CHECK(failed.status == 1);
    CHECK(failed.output.find("FAIL") != std::string::npos);
    CHECK(failed.output.find("cannot compute") != std::string::npos);
    CHECK(failed.errors.empty());
    folder.with("cases/d.json", edited(good, "\"theta_deg\": 0", "\"theta_deg\": NaN"));
    const Ended bad = validated_in(folder);
    CHECK(bad.status == 2);
    CHECK(bad.output.empty());
    CHECK(bad.errors.find("cases/d.json:2: theta_deg: NaN") != std::string::npos);
    CHECK(std::count(bad.errors.begin(), bad.errors.end(), '\n') == 1);
}

TEST_CASE("validate writes its numbers and a page that stands alone", "[program][validate]") {
    const MadeUpFolder folder;
    folder.with("cases/a.json", good);
    CHECK(validated_in(folder, {"--json", "out.json", "--html", "out.html"}).status == 0);
    const auto json = nlohmann::json::parse(content_of(folder / "out.json"));
    CHECK(json["verdict"] == "pass");
    CHECK(json["cases"][0]["points"][0]["quantities"].size() == 1);
    const std::string html = content_of(folder / "out.html");
    CHECK(html.find("M01_\u200bx") != std::string::npos);
    CHECK(html.find("<svg") != std::string::npos);
    CHECK(html.find("<script") == std::string::npos);
}

TEST_CASE("without a folder validate takes the cases of the project", "[program][validate]") {
    const MadeUpFolder folder;
    folder.with("home/tests/reference/a.json", good);
    for (const std::string part : {"materials", "scenes"})
        std::filesystem::create_directory_symlink(SPECULA_SOURCE_DIR "/" + part,
                                                  folder / ("home/" + part));
    const Ended own = run_program({.arguments = {SPECULA_BINARY, "validate"},
                                   .folder = folder.path(),
                                   .environment = {{"SPECULA_HOME", (folder / "home").string()}}});
    CHECK(own.status == 0);
    CHECK(own.output.find("M01_x") != std::string::npos);
    CHECK(own.output.find("1 case, 1 point") != std::string::npos);
    CHECK(specula_in(folder.path(), {"validate", "nowhere"}).status == 2);
}

}  // namespace
}  // namespace specula
