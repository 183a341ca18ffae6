#include "tools/study/calibration.hpp"

#include <nlohmann/json.hpp>
#include <type_traits>

#include "sim/core/error.hpp"
#include "sim/dataset/sha256.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/study/toy_protocol.hpp"
#include "tools/study/study.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;

// What the types promise: nobody makes a frozen calibration but by freezing one, and nobody records
// another geometry without it.
static_assert(!std::is_default_constructible_v<FrozenCalibration>);
static_assert(!std::is_constructible_v<FrozenCalibration, CalibrationOutcome>);
static_assert(std::is_invocable_v<decltype(record_shifted), const FrozenCalibration&, const Source&,
                                  const RunSettings&, const Condition&, Progress&>);
static_assert(!std::is_invocable_v<decltype(record_shifted), const CalibrationOutcome&,
                                   const Source&, const RunSettings&, const Condition&, Progress&>);
static_assert(!std::is_invocable_v<decltype(calibrate), const CalibrationPlan&, const Condition&,
                                   const Extent&>);

Experiment read(const MadeUpFolder& folder, const std::string& text) {
    return read_experiment(folder.with("toy.toml", text), catalogue());
}

TEST_CASE("no shifted geometry is simulated before the calibration lies on disk", "[study]") {
    const MadeUpFolder folder;
    StudyRequest request;
    request.experiment_file = folder.with("toy.toml", toy_protocol());
    request.out = folder / "out";
    request.report = false;
    std::vector<std::string> order;
    bool frozen_first = true;
    request.before_recording = [&](const Condition& condition) {
        order.push_back(condition.name);
        frozen_first = frozen_first && fs::exists(folder / "out/calibration.json");
    };
    const StudySummary study = run_study(request, catalogue());
    CHECK(frozen_first);
    REQUIRE(order.size() > 3);
    CHECK(order.front() == "training");
    // What was frozen is what the results name.
    const std::string text = content_of(folder / "out/calibration.json");
    const std::string sha256 = sha256_of_file(folder / "out/calibration.json");  // as sha256sum
    CHECK(study.results.calibration.sha256 == sha256);
    const auto results = nlohmann::json::parse(content_of(folder / "out/results.json"));
    CHECK(results["calibration"]["frozen_file_sha256"] == sha256);
    CHECK(nlohmann::json::parse(text)["snr_db"] == study.results.calibration.snr_db);
}

TEST_CASE("a calibration refuses training recordings of another geometry", "[study]") {
    const MadeUpFolder folder;
    const RunSettings run{.seed = 7, .worlds = 1, .folder = folder.path()};
    for (const auto* geometry : {"height_mm = [440]", "tilt_deg = [5]", "height_mm = [450, 460]"}) {
        const Experiment shifted =
            read(folder, edited(toy_protocol(), "title = \"Training\"",
                                std::string("title = \"Training\"\n") + geometry));
        const std::string message =
            message_of([&] { NominalSource(shifted, catalogue().materials, run); });
        INFO(geometry);
        CHECK(message.find("training: is not at the nominal height") != std::string::npos);
    }
}

TEST_CASE("where no admissible ratio meets the target, the radar's own stays", "[study]") {
    const MadeUpFolder folder;
    const Experiment toy = read(folder, toy_protocol());
    const RunSettings run{.seed = 7, .worlds = 2, .folder = folder.path()};
    const NominalSource nominal(toy, catalogue().materials, run);
    CalibrationPlan plan;
    plan.target_macro_f1 = 0.02;  // below guessing: out of reach of any noise
    plan.tolerance = 0.01;
    plan.admissible_snr_db = {0.0, 3.0};
    plan.search_snr_db = {-6.0, 3.0};
    const CalibrationOutcome outcome =
        calibrate(plan, nominal, {.worlds = 2, .epochs = 2, .variant_worlds = 1});
    CHECK(outcome.trials.size() > 1);
    CHECK_FALSE(outcome.reached);
    CHECK_FALSE(outcome.matching.has_value());
    CHECK(outcome.snr_db == 0.0);
    for (const CalibrationTrial& trial : outcome.trials) {
        CHECK(trial.snr_db >= -6.0);
        CHECK(trial.snr_db <= 0.0);  // too good already: more signal would not help
    }
}

TEST_CASE("a target that one frame meets takes one trial", "[study]") {
    const MadeUpFolder folder;
    const Experiment toy = read(folder, toy_protocol());
    const RunSettings run{.seed = 7, .worlds = 2, .folder = folder.path()};
    const NominalSource nominal(toy, catalogue().materials, run);
    CalibrationPlan plan;
    plan.target_macro_f1 = nominal.macro_f1(0.0, {.worlds = 2, .epochs = 2});
    const CalibrationOutcome outcome = calibrate(plan, nominal, {.worlds = 2, .epochs = 2});
    CHECK(outcome.reached);
    CHECK(outcome.snr_db == 0.0);
    CHECK(outcome.trials.size() == 1);
}

}  // namespace
}  // namespace specula
