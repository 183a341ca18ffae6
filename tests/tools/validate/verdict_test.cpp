#include "tools/validate/verdict.hpp"

#include <limits>

#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"
#include "tools/validate/validation_json.hpp"
#include "tools/validate/validation_table.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

const Json inp{{"eps", {2.6, -0.026}}, {"theta_deg", 40}};
const std::complex<double> q = std::sqrt(std::complex<double>(2.6, -0.026) - 0.413175911166535);
const std::complex<double> r_te = (0.766044443118978 - q) / (0.766044443118978 + q);

Json fresnel_case(const Json& expect) {
    return case_of("M01_fresnel", inp, expect, {{"abs", 1e-9}});
}

Validation of(const std::vector<Json>& documents) {
    const MadeUpFolder folder;
    for (std::size_t i = 0; i < documents.size(); ++i)
        folder.with(std::to_string(i) + ".json", documents[i].dump());
    return validate({.folder = folder.path(), .threads = 2}, materials_library());
}

const Json right = fresnel_case({{"r_TE", pair_of(r_te)}});
const Json wrong = fresnel_case({{"r_TE", pair_of(r_te + 2e-9)}});
const Json unknown = case_of("Z99_new", inp, {{"r_TE", pair_of(r_te)}}, {{"abs", 1e-9}});

TEST_CASE("a case within its tolerance passes, one beyond it fails with status 1", "[validate]") {
    CHECK(of({right}).exit_status() == 0);
    CHECK(of({right, wrong}).exit_status() == 1);
    CHECK(of({wrong}).cases.front().verdict() == Verdict::fail);
    CHECK(of({wrong}).cases.front().worst()->error == Approx(2e-9));
}

TEST_CASE("a kind that nobody computes fails with status 3 and is shown", "[validate]") {
    const Validation validation = of({right, unknown});
    CHECK(validation.exit_status() == 3);
    CHECK(validation.n_cases_with(Verdict::not_computable) == 1);
    const std::string table = validation_table(validation);
    CHECK(table.find("Z99_new") != std::string::npos);
    CHECK(table.find("cannot compute") != std::string::npos);
    CHECK(table.find("2 cases, 2 points: 1 pass, 0 fail, 1 cannot be computed") !=
          std::string::npos);
}

TEST_CASE("a missed tolerance outweighs what cannot be computed", "[validate]") {
    CHECK(of({unknown, wrong, right}).exit_status() == 1);
}

TEST_CASE("inputs and expectations that nobody asks for are not passed over", "[validate]") {
    Json more_given = right;
    more_given["points"][0]["inp"]["tilt_deg"] = 5;
    const CaseVerdict given = validated(more_given);
    CHECK(given.verdict() == Verdict::not_computable);
    CHECK(given.points.front().problem == "does not know inp.tilt_deg");

    Json more_wanted = right;
    more_wanted["points"][0]["expect"]["t_TE"] = 1;
    const CaseVerdict wanted = validated(more_wanted);
    CHECK(wanted.verdict() == Verdict::not_computable);
    CHECK(wanted.points.front().problem == "does not compute expect.t_TE");
}

TEST_CASE("a point may lack quantities, and null is no value", "[validate]") {
    CHECK(validated(fresnel_case({{"r_TE", pair_of(r_te)}, {"r_TM", nullptr}})).verdict() ==
          Verdict::pass);
}

TEST_CASE("lists are compared element by element, and as long as they are", "[validate]") {
    const auto echoes = [](const Json& levels) {
        return case_of("F09_if_hpf", {{"fc_hz", 175e3}, {"fs_hz", 12.5e6}, {"N", 256}},
                       {{"bins_1_to_2_db", levels}}, {{"db", 0.05}});
    };
    CHECK(validated(echoes({-22.8258943, -12.4882493})).verdict() == Verdict::pass);
    const CaseVerdict off = validated(echoes({-22.8258943, -12.3}));
    CHECK(off.verdict() == Verdict::fail);
    CHECK(off.worst()->name == "bins_1_to_2_db[1]");
    CHECK(validated(echoes({-22.8258943})).verdict() == Verdict::fail);
}

TEST_CASE("what is not a number misses every tolerance", "[validate]") {
    Quantity quantity{.name = "x",
                      .computed = 1.0,
                      .expected = 1.0,
                      .error = std::numeric_limits<double>::quiet_NaN(),
                      .tolerance = 1e300,
                      .unit = ""};
    CHECK_FALSE(quantity.passes());
    CHECK(std::isinf(quantity.share()));
    quantity.error = 0.0;
    quantity.tolerance = 0.0;
    CHECK(quantity.passes());
    CHECK(quantity.share() == 0.0);
    quantity.error = 1.0;
    CHECK(std::isinf(quantity.share()));
}

TEST_CASE("quantities that are not judged fail nothing", "[validate]") {
    const PointVerdict point{
        .quantities = {{"a", 1.0, 1.0, 0.0, 1.0, ""}, {"b", 9.0, 1.0, 8.0, 1.0, "", false}},
        .problem = {}};
    CHECK(point.verdict() == Verdict::pass);
    CHECK(point.worst()->name == "a");
}

TEST_CASE("rows that the tolerance's note calls informative are shown, not judged", "[validate]") {
    const auto metal = [](const char* name, const char* note) {
        Json document = case_of("M05_metals",
                                {{"metal", name}, {"sigma", 1e7}, {"f_hz", 60e9}, {"theta_deg", 0}},
                                {{"R_TE_dB", -99.0}}, {{"R_dB", 0.1}});
        document["tolerance"]["note"] = note;
        return validated(document);
    };
    const char* note = "Mild steel rows are a guess, informative. Copper rows are exact.";
    CHECK(metal("mild steel", note).verdict() == Verdict::pass);
    CHECK(metal("mild steel", note).worst() == nullptr);
    CHECK(metal("mild steel", note).n_shown_only() == 1);
    CHECK(metal("copper", note).verdict() == Verdict::fail);
    CHECK(metal("steel", "stainless-steel rows: informative").verdict() == Verdict::pass);
    CHECK(metal("less", "stainless-steel rows: informative").verdict() == Verdict::fail);
    CHECK(metal("", "some rows;  informative").verdict() == Verdict::fail);
}

TEST_CASE("the JSON holds every quantity with what was computed and expected", "[validate]") {
    const Json json = Json::parse(validation_json(of({right, wrong, unknown})));
    CHECK(json["format"] == "specula-validation");
    CHECK(json["verdict"] == "fail");
    CHECK(json["n_cases_pass"] == 1);
    CHECK(json["n_cases_fail"] == 1);
    CHECK(json["n_cases_not_computable"] == 1);
    const Json& quantity = json["cases"][1]["points"][0]["quantities"][0];
    CHECK(quantity["name"] == "r_TE");
    CHECK(quantity["computed"][0].get<double>() == Approx(r_te.real()).epsilon(1e-12));
    CHECK(quantity["pass"] == false);
    CHECK(json["cases"][1]["worst"]["point"] == 0);
    CHECK(json["cases"][2]["points"][0]["problem"].get<std::string>().find("Z99") !=
          std::string::npos);
}

TEST_CASE("names from files put no control characters on the terminal", "[validate]") {
    Json document = wrong;
    document["id"] = "M01_\x1b[31m";
    document["title"] = "two\nlines";
    const std::string table = validation_table(of({document}));
    CHECK(table.find('\x1b') == std::string::npos);
    CHECK(table.find("two\nlines") == std::string::npos);
}

}  // namespace
}  // namespace specula
