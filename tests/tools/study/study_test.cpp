#include "tools/study/study.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "classifier/extract_features.hpp"
#include "sim/core/error.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/sha256.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/study/toy_experiment.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The toy study, run once per number of threads and kept.
class ToyStudy : public MadeUpFolder {
  public:
    explicit ToyStudy(int threads, std::uint64_t seed = 7) {
        StudyRequest request;
        request.experiment_file = with("toy.toml", toy_experiment);
        request.out = path() / "out";
        request.threads = threads;
        request.seed = seed;
        request.command = "specula study toy";
        summary = run_study(request, catalogue());
    }
    fs::path out(const std::string& name) const { return path() / "out" / name; }
    Dataset dataset(const std::string& name) const {
        return read_dataset(out("datasets") / (name + ".h5"));
    }
    Json results() const { return Json::parse(content_of(out("results.json"))); }

    StudySummary summary;
};

const ToyStudy& toy() {
    static const ToyStudy held(1);
    return held;
}

TEST_CASE("a study writes the same bytes on one thread and on two", "[study]") {
    const ToyStudy second(2);
    std::size_t n_compared = 0;
    for (const auto* part : {"results.json", "datasets", "models", "firmware"})
        for (const auto& entry : fs::recursive_directory_iterator(toy().path() / "out")) {
            const fs::path name = fs::relative(entry.path(), toy().path() / "out");
            if (!entry.is_regular_file() || *name.begin() != part) continue;
            INFO(name.string());
            const bool same = content_of(entry.path()) == content_of(second.path() / "out" / name);
            CHECK(same);
            ++n_compared;
        }
    CHECK(n_compared ==
          1 + 3 + 2 + 2);  // results, datasets, models of two worlds, header and source
    const bool same = content_of(toy().out("report.html")) == content_of(second.out("report.html"));
    CHECK(same);
}

TEST_CASE("another seed is another study", "[study]") {
    const ToyStudy other(2, 8);
    CHECK(fingerprint(other.dataset("training")) != fingerprint(toy().dataset("training")));
    CHECK(other.results()["seed"] == 8);
    CHECK(other.dataset("height").origin.seed == 8);
}

// One case with sections: under ctest every case is a process, and would run the study anew.
TEST_CASE("what a study writes is what it recorded, trained and judged", "[study]") {
    SECTION("what is recorded anew repeats no session of the training") {
        const Dataset training = toy().dataset("training");
        const Dataset anew = toy().dataset("rerecorded");
        std::set<std::int32_t> sessions, pieces;
        std::set<double> heights_m;
        std::set<std::vector<std::int16_t>> frames;
        const auto codes = [](const Dataset& dataset, std::size_t i) {
            const auto* first = dataset.frame(i).samples;
            return std::vector<std::int16_t>(first, first + dataset.codes_per_frame());
        };
        for (std::size_t i = 0; i < training.n_frames(); ++i) {
            sessions.insert(training.truth[i].session);
            pieces.insert(training.truth[i].sample);
            heights_m.insert(training.truth[i].height_m);
            frames.insert(codes(training, i));
        }
        for (std::size_t i = 0; i < anew.n_frames(); ++i) {
            CHECK(sessions.count(anew.truth[i].session) == 0);
            CHECK(heights_m.count(anew.truth[i].height_m) == 0);
            CHECK(frames.count(codes(anew, i)) == 0);
            CHECK(pieces.count(anew.truth[i].sample) == 1);  // but of the same pieces
        }
    }
    SECTION("every dataset carries the experiment, and results the fingerprint of its codes") {
        const Json results = toy().results();
        for (const std::string name : {"training", "rerecorded", "height"}) {
            const Dataset dataset = toy().dataset(name);
            CHECK(dataset.origin.experiment == toy_experiment);
            CHECK(dataset.origin.condition == name);
            CHECK(dataset.origin.radar == "iwrl6432boost");
            CHECK(results["fingerprints"][name + ".h5"] == "fingerprint " + fingerprint(dataset));
        }
        const std::string frozen = results["calibration"]["frozen_file_sha256"];
        CHECK(results["fingerprints"]["calibration.json"] == "sha256 " + frozen);
        CHECK(results["fingerprints"]["toy.toml"] == "sha256 " + sha256_of(toy_experiment));
        CHECK(results["fingerprints"].size() == 5);
    }
    SECTION("results count every frame once and agree with their own confusion") {
        const Json results = toy().results();
        REQUIRE(results["conditions"].size() == 3);  // held back, recorded anew, height
        CHECK(results["conditions"][0]["name"] == "nominal");
        CHECK(results["conditions"][1]["frames"] == toy().dataset("rerecorded").n_frames());
        CHECK(results["conditions"][2]["frames"] == toy().dataset("height").n_frames());
        for (const Json& condition : results["conditions"]) {
            INFO(condition["name"]);
            std::int64_t counted = 0, binned = 0;
            for (const Json& row : condition["confusion_true_by_predicted"])
                for (const Json& n : row) counted += n.get<std::int64_t>();
            for (const auto* side : {"correct", "wrong"})
                for (const Json& n : condition["confidence_histogram"][side])
                    binned += n.get<std::int64_t>();
            CHECK(counted == condition["frames"]);
            CHECK(binned == condition["frames"]);
            REQUIRE(condition["macro_f1_per_world"].size() == 2);
            const double mean = 0.5 * (condition["macro_f1_per_world"][0].get<double>() +
                                       condition["macro_f1_per_world"][1].get<double>());
            CHECK(condition["macro_f1"]["mean"].get<double>() == Approx(mean));
            CHECK(condition["macro_f1"]["low_95"].get<double>() <= mean + 1e-12);
            CHECK(condition["macro_f1"]["high_95"].get<double>() >= mean - 1e-12);
            // Both classes merged into one: nothing can be confused any more.
            CHECK(condition["macro_f1_merged"]["mean"] == 1.0);
        }
        CHECK(results["conditions"][0]["paper_macro_f1"] == 0.9);
        CHECK(results["conditions"][1]["paper_macro_f1"].is_null());
        CHECK(results["format"] == "specula-results");
    }
    SECTION("held-back frames are neither trained on nor left out") {
        const Json results = toy().results();
        const auto held_back = results["conditions"][0]["frames"].get<std::size_t>();
        std::size_t trained = 0;
        for (const auto* world : {"world_000.json", "world_001.json"}) {
            const Json model = Json::parse(content_of(toy().out("models") / world));
            trained += std::stoul(model["provenance"]["training rows"].get<std::string>());
        }
        CHECK(trained + held_back == toy().dataset("training").n_frames());
        CHECK(held_back > 0);
    }
    SECTION("class profiles in the report are means over the dataset's descriptors") {
        const StudyCondition& height = toy().summary.conditions[2];
        REQUIRE(height.features.size() == 2);
        const Dataset dataset = toy().dataset("height");
        const FeatureTable rows = extract_features(
            dataset, {6, 12, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, FW_RANGE_FLOAT}, 1);
        for (std::size_t label = 0; label < 2; ++label) {
            double sum = 0.0, square = 0.0, n = 0.0;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (rows.label[i] != label) continue;
                const double value = rows.row(i)[3];
                sum += value;
                square += value * value;
                n += 1.0;
            }
            REQUIRE(n == 8);  // 2 worlds, 2 heights, 2 frames
            CHECK(height.features[label].mean[3] == Approx(sum / n));
            CHECK(height.features[label].sd[3] ==
                  Approx(std::sqrt(square / n - sum * sum / (n * n))).epsilon(1e-6));
        }
    }
}

TEST_CASE("a study says which materials it uses outside their band", "[study]") {
    // Its sheet of 6 cm is 12 wavelengths wide, and no metal.
    REQUIRE(toy().summary.warnings.size() == 1);
    CHECK(toy().summary.warnings[0].rfind("sheet: the sample, no metal, is", 0) == 0);
    CHECK(toy().results()["warnings"][0] == toy().summary.warnings[0]);
    const MadeUpFolder folder;
    StudyRequest request;
    request.experiment_file =
        folder.with("toy.toml", edited(toy_experiment, "\"plexiglass\"", "\"brick\""));
    request.out = folder / "out";
    const StudySummary study = run_study(request, catalogue());
    REQUIRE(study.warnings.size() == 2);
    CHECK(study.warnings[0].rfind("brick: valid from 1 to 40 GHz, used from 58", 0) == 0);
    CHECK(content_of(folder / "out/report.html").find("brick: valid from") != std::string::npos);
}

TEST_CASE("a study says how many of its echoes are too weak for physical optics", "[study]") {
    const MadeUpFolder folder;
    StudyRequest request;
    request.experiment_file =
        folder.with("toy.toml", edited(toy_experiment, "height_mm = [350, 550]",
                                       "tilt_deg = [-25, 25]\ntilted = \"sample\""));
    request.out = folder / "out";
    // The foot of 19 cm is far off sheets of 6 cm; straight from above, toy() has no such warning.
    const StudySummary tilted = run_study(request, catalogue());
    REQUIRE(tilted.warnings.size() == toy().summary.warnings.size() + 1);
    CHECK(tilted.warnings.back().rfind("Height: 8 of 8 sessions have an echo 15 dB or more", 0) ==
          0);  // worlds x classes x tilts
    CHECK(content_of(folder / "out/report.html").find("8 of 8 sessions") != std::string::npos);
}

TEST_CASE("a folder that cannot be made is named", "[study]") {
    const MadeUpFolder folder;
    StudyRequest request;
    request.experiment_file = folder.with("toy.toml", toy_experiment);
    request.out = folder.with("taken", "a file") / "out";
    try {
        run_study(request, catalogue());
        FAIL("no error");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).rfind(request.out.string(), 0) == 0);
    }
}

}  // namespace
}  // namespace specula
