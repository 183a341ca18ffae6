#include "tools/serve/page_bench.hpp"

#include "firmware/fw_extract.h"
#include "sim/generate.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/serve/project_names.hpp"
#include "tools/serve/chirp_answer.hpp"
#include "tools/serve/level_curve.hpp"
#include "tools/serve/rung.hpp"
#include "tools/sweep/sweep.hpp"

namespace specula {
namespace {

const Experiment& experiment() {
    static const Experiment read = page_experiment(catalogue());
    return read;
}

SceneRequest tilted_wood() {
    return read_request(parse_json(R"({"material": "wood", "thickness_mm": 17.25, "size_mm": 220,
        "roughness_um": 30, "tilt_deg": -4.5, "tilted": "sample", "height_mm": 437.5,
        "session": 0, "frame": 3})"),
                        known());
}

TEST_CASE("what the page records in session 0 is what the command makes of its scene file",
          "[serve]") {
    const SceneRequest request = tilted_wood();
    const MadeUpFolder folder;
    const auto file = folder.with("scene.toml", scene_toml(request, *known().radar(request.radar)));
    const Scene scene = read_scene(file, catalogue());
    Stream noise({.seed = 3, .purpose = "thermal noise"});
    const AdcFrame of_file = simulate(scene, catalogue().materials, noise);
    const PageChirp chirp = simulate_request(request, experiment(), catalogue(), known());
    CHECK(chirp.frame.codes == of_file.codes);

    const SceneRequest back = request_of_file(file, catalogue());
    CHECK(back.thickness_mm == Approx(17.25).epsilon(1e-12));  // rounding of mm to m and back
    CHECK(back.tilt_deg == Approx(-4.5).epsilon(1e-12));
    CHECK(back.tilted == "sample");
}

TEST_CASE("session 1 of a training piece is the very training recording", "[serve]") {
    const Bench bench = bench_of(experiment(), catalogue().materials);
    const int plexiglass = 2;
    const SessionFrames recorded =
        simulate_session(bench, experiment().training, {.label = plexiglass});
    const Truth& truth = recorded.truth.front();
    SceneRequest request;
    request.material = "plexiglass";
    request.thickness_mm = truth.thickness_m * 1e3;
    request.bow_mm = truth.bow_m * 1e3;
    request.roughness_um = truth.roughness_m * 1e6;
    request.frame = 2;
    const PageChirp chirp = simulate_request(request, experiment(), catalogue(), known());
    const std::size_t n = chirp.frame.codes.size();
    REQUIRE(recorded.adc.size() >= 3 * n);
    int differences = 0;
    for (std::size_t i = 0; i < n; ++i)  // mm from m and back may turn a rounding by one code
        if (std::abs(chirp.frame.codes[i] - recorded.adc[2 * n + i]) > 1) ++differences;
    CHECK(differences == 0);
}

TEST_CASE("leakage and noise of the board follow their sliders", "[serve]") {
    SceneRequest request = tilted_wood();
    const auto first_bins = [&] {
        const PageChirp chirp = simulate_request(request, experiment(), catalogue(), known());
        const auto profile = whole_profile(chirp.frame.view());
        return std::pair(profile[2], profile[50]);
    };
    const auto usual = first_bins();
    request.leakage = false;
    CHECK(first_bins().first < 0.2f * usual.first);
    request.noise_figure_db += 20.0;
    CHECK(first_bins().second > 4.0f * usual.second);  // 20 dB are a factor of 10, one draw each
}

TEST_CASE("a curve of the page is the sweep of the command line", "[serve]") {
    SceneRequest request = tilted_wood();
    request.size_mm = 150.0;
    const std::atomic<bool> stop{false};
    const Scene scene = requested_scene(request, catalogue(), known());
    const LevelCurve curve = level_curve(
        scene,
        {.axis = CurveAxis::tilt, .tilting = tilting_of(request), .most_s = 60.0, .stop = stop},
        catalogue().materials);
    REQUIRE(curve.x.size() == 81);
    const MadeUpFolder folder;
    const auto file = folder.with("scene.toml", scene_toml(request, *known().radar(request.radar)));
    const SweepPlan plan =
        read_sweep_plan(file, {.tilt = "-20:20:10", .tilted = "sample"}, catalogue());
    std::atomic<std::size_t> done{0};
    const Sweep sweep = run_sweep(plan, catalogue().materials, 1, done);
    for (std::size_t i = 0; i < sweep.rows.size(); ++i)
        CHECK(curve.level_db[20 * i] == static_cast<float>(sweep.rows[i].over_mirror_db));
}

TEST_CASE("a curve ends when the server does, and is coarse where its time is over", "[serve]") {
    const Scene scene = requested_scene(tilted_wood(), catalogue(), known());
    const std::atomic<bool> stop{true}, on{false};
    CHECK(level_curve(scene, {.tilting = {}, .stop = stop}, catalogue().materials).x.empty());
    const LevelCurve curve =
        level_curve(scene, {.tilting = {}, .most_s = 0.0, .stop = on}, catalogue().materials);
    CHECK(curve.x == std::vector<float>{-20, -16, -12, -8, -4, 0, 4, 8, 12, 16, 20});
}

TEST_CASE("the paper's features are the extractor's, the aligned ones follow the peak", "[serve]") {
    const PageChirp chirp = simulate_request(tilted_wood(), experiment(), catalogue(), known());
    const fw_frame view = chirp.frame.view();
    std::vector<float> scratch(fw_extract_scratch(&view) / sizeof(float) + 1);
    std::array<float, 12> extracted{};
    REQUIRE(fw_extract(&view, &experiment().descriptor, scratch.data(),
                       scratch.size() * sizeof(float), extracted.data()) == FW_OK);
    CHECK(rung_features(rung_recipes[0], whole_profile(view)) == extracted);

    std::vector<float> profile(64, 1.0f), moved(64, 1.0f);
    for (int i = -2; i <= 2; ++i) {
        profile[static_cast<std::size_t>(12 + i)] = moved[static_cast<std::size_t>(15 + i)] =
            100.0f / (1.0f + static_cast<float>(i * i));
    }
    const auto here = rung_features(rung_recipes[2], profile),
               there = rung_features(rung_recipes[2], moved);
    for (std::size_t k = 4; k < 8; ++k)  // the peak; times range, 15 bins over 12; rounding
        CHECK(there[k] - here[k] == Approx(std::log(15.0 / 12.0)).margin(1e-5));
}

TEST_CASE("the CSV of a chirp has a row per sample and the codes of every RX", "[serve]") {
    const PageChirp chirp = simulate_request(tilted_wood(), experiment(), catalogue(), known());
    std::istringstream lines(chirp_csv(chirp));
    std::string line;
    std::getline(lines, line);
    CHECK(line == "time_us,frequency_ghz,rx0_lsb,rx1_lsb,rx2_lsb");
    std::getline(lines, line);
    const auto& codes = chirp.frame.codes;
    const std::string end = "," + std::to_string(codes[0]) + "," + std::to_string(codes[128]) +
                            "," + std::to_string(codes[256]);
    CHECK(line.substr(line.size() - end.size()) == end);
    int rows = 1;
    while (std::getline(lines, line)) ++rows;
    CHECK(rows == 128);
}

}  // namespace
}  // namespace specula
