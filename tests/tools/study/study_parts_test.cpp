#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "classifier/descriptor.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/tools/study/toy_protocol.hpp"
#include "tools/report/study_figures.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/study.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// The toy study with all its parts, kept.
class WholeToy : public MadeUpFolder {
  public:
    explicit WholeToy(int threads) {
        static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
        StudyRequest request;
        request.experiment_file = with("toy.toml", toy_protocol());
        request.out = path() / "out";
        request.threads = threads;
        request.command = "specula study toy";
        request.report = false;  // two dozen figures take longer than all the rest
        summary = run_study(request, catalogue);
    }
    std::string out(const std::string& name) const { return content_of(path() / "out" / name); }

    StudySummary summary;
};

const HonestyCheck& check_named(const StudySummary& study, const std::string& name) {
    for (const HonestyCheck& check : study.results.checks)
        if (check.name == name) return check;
    throw std::runtime_error("no check " + name);
}

// One case: under ctest every case is a process, and would run the study anew.
TEST_CASE("a study with all its parts says the same on one thread and on two", "[study]") {
    static const WholeToy one(1), two(2);
    const bool same_results = one.out("results.json") == two.out("results.json");
    CHECK(same_results);

    const StudyResults& results = one.summary.results;
    const Json json = Json::parse(one.out("results.json"));

    SECTION("conditions of two heights also come apart, and add up") {
        REQUIRE(json["parts_of_conditions"].size() == 2);
        std::int64_t frames = 0;
        for (const Json& part : json["parts_of_conditions"]) frames += part["frames"].get<int>();
        CHECK(json["conditions"][2]["frames"] == frames);
        REQUIRE(json["parts_of_conditions"][0]["heights_m"].size() == 1);
        CHECK(json["parts_of_conditions"][0]["heights_m"][0].get<double>() == Approx(0.35));
    }
    SECTION("every part that was asked for is there") {
        for (const auto* part :
             {"calibration", "waterfall", "sensitivity", "prior_draws", "honesty_checks", "ladder",
              "severity_grid", "detectors", "fallback", "confidence", "drift"}) {
            INFO(part);
            CHECK(json.contains(part));
        }
        std::set<std::string> drawn;
        for (const StudyFigure& figure : study_figures(one.summary))
            drawn.insert(figure.figure.name);
        for (const auto* figure : {"waterfall", "sensitivity", "ladder", "ladder_gains", "severity",
                                   "severity_curves", "severity_receiver", "honesty", "detectors",
                                   "reliability", "risk_coverage", "input_drift"}) {
            INFO(figure);
            CHECK(drawn.count(figure) == 1);
        }
    }
    SECTION("the first rung is the study's own classifier, and gains nothing over itself") {
        REQUIRE(results.ladder.size() == 3);
        for (std::size_t domain = 0; domain < results.ladder[0].domains.size(); ++domain) {
            CHECK(results.ladder[0].gain[domain].mean == 0.0);
            CHECK(results.ladder[0].domains[domain].all.mean ==
                  Approx(one.summary.conditions[domain].result.macro_f1.mean));
        }
        CHECK(results.ladder[0].cost.n_features == 12);
        // 12 inputs, 6 units, 2 classes, and nothing before them.
        CHECK(results.ladder[0].cost.multiplications == 12 * 6 + 6 * 2);
        CHECK(results.ladder[1].cost.multiplications > results.ladder[0].cost.multiplications);
        CHECK(results.ladder[2].descriptor == "range_bins 6 12 blackman looks 2 spread in motion");
        CHECK(results.ladder[2].cost.n_features == 24);
    }
    SECTION("scores behind the recommendation are of worlds that had no say in it") {
        CHECK(results.choosing_worlds == std::vector<std::size_t>{0});
        for (const LadderRung& rung : results.ladder)
            for (std::size_t domain = 0; domain < rung.domains.size(); ++domain)
                CHECK(rung.confirmed[domain].all.mean ==
                      Approx(rung.domains[domain].per_world.all[1]));
    }
    SECTION("the recommended model is kept, and the firmware's blob or the reason why there is none") {
        const Model model = read_model(one.path() / "out/models/remedy_world_000.json");
        const auto best = std::ranges::find_if(
            results.ladder, [](const LadderRung& rung) { return rung.recommended; });
        REQUIRE(best != results.ladder.end());
        CHECK(best->descriptor.starts_with(descriptor_of(model).text()));
        REQUIRE(results.device);
        CHECK(results.device->blob.empty() != results.device->why_no_blob.empty());
        CHECK(fs::exists(one.path() / "out/firmware/remedy.rfwm") ==
              !results.device->blob.empty());
        CHECK(json["recommendation"]["blob"].is_null() == results.device->blob.empty());
    }
    SECTION("one quantity has one interval") {
        const Json& steps = json["waterfall"];
        REQUIRE(steps.size() >= 2);
        CHECK(steps[0]["macro_f1"] == json["conditions"][0]["macro_f1"]);
        CHECK(steps[1]["macro_f1"] == json["conditions"][1]["macro_f1"]);
        CHECK(json["ladder"][0]["domains"][0]["macro_f1"].contains("low_95_over_worlds"));
    }
    SECTION("bins of the reliability count every frame once") {
        for (std::size_t i = 0; i < results.confidence.size(); ++i) {
            std::int64_t n = 0;
            for (const ReliabilityPoint& point : results.confidence[i].reliability) {
                n += static_cast<std::int64_t>(point.n);
                CHECK(point.accuracy.low <= point.accuracy.mean + 1e-12);
                CHECK(point.accuracy.high >= point.accuracy.mean - 1e-12);
            }
            CHECK(n == one.summary.conditions[i].result.n_frames);
        }
    }
    SECTION("a check over two worlds that passes is called weak") {
        std::size_t n_banded = 0;
        for (const Json& check : json["honesty_checks"]) {
            CHECK(check["worlds"] == 2);
            const bool has_interval = check["check"] != "same_nuisance";
            CHECK(check["value"]["low_95_over_worlds"].is_null() != has_interval);
            if (check["band"].is_null()) continue;
            ++n_banded;
            CHECK(check["weak_evidence"] == true);
        }
        CHECK(n_banded >= 4);
    }
    SECTION("what merging gains has the interval of its two worlds") {
        const HonestyCheck& merging = check_named(one.summary, "merged_at_least");
        std::vector<std::array<double, 2>> spans;
        for (const StudyCondition& condition : one.summary.conditions) {
            const ConditionReport& r = condition.result;
            const double first = r.macro_f1_merged_per_world[0] - r.macro_f1_per_world[0];
            const double second = r.macro_f1_merged_per_world[1] - r.macro_f1_per_world[1];
            spans.push_back({std::min(first, second), std::max(first, second)});
        }
        const std::array<double, 2> smallest = *std::ranges::min_element(
            spans, {}, [](const auto& span) { return span[0] + span[1]; });
        // A quarter of the resamples of two worlds holds one of them twice.
        CHECK(merging.value.low == Approx(smallest[0]));
        CHECK(merging.value.high == Approx(smallest[1]));
    }
    SECTION("the grid holds every height with every tilt, and the receiver's cells") {
        CHECK(results.severity.height_offsets_m == std::vector<double>{0.0, 0.05});
        REQUIRE(results.severity.cells.size() == 2 * 2 + 1);
        CHECK(results.severity.cells.back().receiver == "gain +3 dB");
        CHECK(results.severity.relative_error.front() == Approx(1.0));
    }
    SECTION("checks of what must be so by construction hold") {
        CHECK(check_named(one.summary, "no_nuisance").passed);
        CHECK(check_named(one.summary, "same_nuisance").passed);
        CHECK_FALSE(check_named(one.summary, "leak_meter").band.has_value());
        // Both classes of the toy merge into one: nothing can be confused.
        CHECK(check_named(one.summary, "merged_at_least").passed);
    }
    SECTION("assumptions begin with the study's own") {
        REQUIRE(results.sensitivity.size() >= 2);
        CHECK(results.sensitivity[0].name == "reference");
        CHECK(results.sensitivity[1].name == "hann");
        CHECK(results.sensitivity[0].domains.size() == 2);  // nominal and height
        // Another window describes the same recordings otherwise.
        CHECK(results.sensitivity[0].fingerprint == results.sensitivity[1].fingerprint);
    }
}

TEST_CASE("a rung that names no training set or descriptor is refused", "[study]") {
    static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    const MadeUpFolder folder;
    const auto refusal = [&](const std::string& from, const std::string& to) {
        try {
            read_experiment(folder.with("toy.toml", edited(toy_protocol(), from, to)), catalogue);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("(no error)");
    };
    CHECK(
        refusal("training = \"heights\"", "training = \"depths\"").find("training = \"depths\"") !=
        std::string::npos);
    CHECK(refusal("range_bins 6 12 blackman align", "range_bin 6 12 blackman align")
              .find("descriptor") != std::string::npos);
    CHECK(refusal("[motion]\ndisplacement_um = { normal = [0.0, 500.0] }\n", "")
              .find("needs a [motion]") != std::string::npos);
    CHECK(refusal("admissible_snr_db = [0, 6]", "admissible_snr_db = [1, 6]")
              .find("does not hold 0") != std::string::npos);
    CHECK(refusal("variant_conditions = [\"height\"]", "variant_conditions = [\"heigth\"]")
              .find("is no condition of this experiment") != std::string::npos);
}

}  // namespace
}  // namespace specula
