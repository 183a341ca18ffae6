#include "tools/validate/case_file.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/tools/validate/made_up_case.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

Json good_case() {
    return case_of("M03_slab",
                   {{"eps", {2.6, -0.026}}, {"d_m", 0.005}, {"theta_deg", 30}, {"f_hz", 60e9}},
                   {{"r_TE", {0.0, 0.0}}}, {{"abs", 1e-9}});
}

/// What is said about a text, without the name of the folder it lay in.
std::string complaint_on(const std::string& text) {
    const std::string message = message_of([&] { return validated_text(text); });
    const auto at = message.find("case.json:");
    return at == std::string::npos ? message : message.substr(at);
}

std::string complaint_on(const Json& document) {
    return complaint_on(document.dump(1));
}

bool begins_with(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

TEST_CASE("a file that is no JSON is named with the line and the field before the fault",
          "[validate]") {
    CHECK(begins_with(complaint_on(std::string("hello")), "case.json:1: not JSON"));
    CHECK(begins_with(complaint_on(std::string("")), "case.json:1: not JSON"));
    CHECK(begins_with(complaint_on(std::string("{\n \"id\": \"M03\",\n \"title\": oops}")),
                      "case.json:3: title: not JSON"));
    CHECK(begins_with(complaint_on(std::string(100000, '[')), "case.json:1: not JSON"));
}

TEST_CASE("what is no number to JSON is refused by name", "[validate]") {
    const std::string text = good_case().dump(1);
    for (const char* number : {"NaN", "Infinity", "-Infinity"}) {
        const std::string complaint = complaint_on(edited(text, "0.005", number));
        CHECK(complaint.find("d_m: NaN and Infinity are no numbers") != std::string::npos);
    }
    const std::string complaint = complaint_on(edited(text, "0.005", "1e999"));
    CHECK(complaint.find("d_m = 1e999: beyond") != std::string::npos);
}

TEST_CASE("a field that a case needs is named when it is missing", "[validate]") {
    for (const char* field : {"id", "title", "tolerance", "points"}) {
        Json document = good_case();
        document.erase(field);
        CHECK(
            begins_with(complaint_on(document), std::string("case.json: ") + field + ": missing"));
    }
    for (const char* part : {"inp", "expect"}) {
        Json document = good_case();
        document["points"][0].erase(part);
        CHECK(begins_with(complaint_on(document),
                          std::string("case.json: points[0].") + part + ": missing"));
    }
    Json document = good_case();
    document["points"][0]["inp"].erase("d_m");
    CHECK(begins_with(complaint_on(document), "case.json: points[0].inp.d_m: missing"));
    document = good_case();
    document["tolerance"] = Json::object();
    CHECK(begins_with(complaint_on(document), "case.json: tolerance.abs: missing"));
}

TEST_CASE("a field of another type is named with its value", "[validate]") {
    const auto with = [](const char* pointer, const Json& value) {
        Json document = good_case();
        document[Json::json_pointer(pointer)] = value;
        return complaint_on(document);
    };
    CHECK(begins_with(with("/id", 3), "case.json: id: not a text"));
    CHECK(begins_with(with("/points", 3), "case.json: points: not a list"));
    CHECK(begins_with(with("/points", Json::array()), "case.json: points: empty"));
    CHECK(begins_with(with("/points/0", 3), "case.json: points[0]: not an object"));
    CHECK(begins_with(with("/points/0/inp", Json::array({1})),
                      "case.json: points[0].inp: not an object"));
    CHECK(begins_with(with("/points/0/expect", Json::object()),
                      "case.json: points[0].expect: empty"));
    CHECK(begins_with(with("/points/0/inp/eps", "abc"),
                      "case.json: points[0].inp.eps = \"abc\": not a complex number"));
    CHECK(begins_with(with("/points/0/inp/eps", {1, 2, 3}),
                      "case.json: points[0].inp.eps = [1,2,3]: not a complex number"));
    CHECK(begins_with(with("/points/0/inp/d_m", {1}),
                      "case.json: points[0].inp.d_m = [1]: not a number"));
    CHECK(begins_with(with("/points/0/expect/r_TE", "x"),
                      "case.json: points[0].expect.r_TE = \"x\": not a complex number"));
    CHECK(begins_with(with("/tolerance", 1), "case.json: tolerance: not an object"));
    CHECK(
        begins_with(with("/tolerance/abs", "x"), "case.json: tolerance.abs = \"x\": not a number"));
}

TEST_CASE("values that no case can mean are refused with what would do", "[validate]") {
    const auto with = [](const char* pointer, const Json& value) {
        Json document = good_case();
        document[Json::json_pointer(pointer)] = value;
        return complaint_on(document);
    };
    CHECK(with("/points/0/inp/theta_deg", 95) ==
          "case.json: points[0].inp.theta_deg = 95: out of range; use a value of 0 or more and "
          "below 90");
    CHECK(with("/points/0/inp/d_m", 0) ==
          "case.json: points[0].inp.d_m = 0: out of range; use a value above 0");
    CHECK(with("/points/0/inp/eps", {2.6, 0.026}).find("gain") != std::string::npos);
    CHECK(begins_with(with("/tolerance/abs", -1), "case.json: tolerance.abs = -1: out of range"));
}

TEST_CASE("what several files do wrong is said of the first, on any number of threads",
          "[validate]") {
    const MadeUpFolder folder;
    Json broken = good_case();
    broken["points"][0]["inp"].erase("d_m");
    folder.with("b.json", broken.dump());
    broken["points"][0]["inp"].erase("eps");
    folder.with("a.json", broken.dump());
    for (const int threads : {1, 4}) {
        const std::string message = message_of([&] {
            return validate({.folder = folder.path(), .threads = threads}, materials_library());
        });
        CHECK(message.find("a.json: points[0].inp.eps: missing") != std::string::npos);
    }
}

TEST_CASE("files beside the cases that are none are listed, not read as cases", "[validate]") {
    const MadeUpFolder folder;
    folder.with("M03.json", good_case().dump());
    folder.with("index.json", "{\"cases\": []}");
    folder.with("README.md", "no JSON");
    const CaseFolder read = read_case_folder(folder.path());
    REQUIRE(read.cases.size() == 1);
    CHECK(read.cases.front().kind() == "M03");
    CHECK(read.others == std::vector<std::string>{"index.json"});
}

TEST_CASE("a folder without cases, or none at all, is refused", "[validate]") {
    const MadeUpFolder folder;
    const auto reading = [](const std::filesystem::path& path) {
        return message_of([&] { return read_case_folder(path); });
    };
    CHECK(reading(folder.path()).find("holds no case file") != std::string::npos);
    CHECK(reading(folder.path() / "absent").find("no such folder") != std::string::npos);
    folder.with("a.json", "[]");
    CHECK(reading(folder.path()).find("a.json: the file: not an object") != std::string::npos);
}

TEST_CASE("one case file may be named instead of a folder", "[validate]") {
    const MadeUpFolder folder;
    CHECK(read_case_folder(folder.with("any name.json", good_case().dump())).cases.size() == 1);
}

}  // namespace
}  // namespace specula
