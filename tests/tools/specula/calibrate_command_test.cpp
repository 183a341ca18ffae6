#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

TEST_CASE("show explains a TI command file and what it means for a sample", "[program][show]") {
    const MadeUpFolder folder;
    const auto file = folder.with("stock.cfg",
                                  "channelCfg 7 1 0\nchirpComnCfg 20 0 0 128 1 30 2\n"
                                  "chirpTimingCfg 6 28 0 90 59.75\nmysteryCfg 1\n");
    const Ended shown = specula_in(folder.path(), {"show", file.string()});
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "range bin          6.506 cm, farthest range 3.747 m"));
    CHECK(contains(shown.output, "at 450 mm falls into bin 6.92, beat 270.2 kHz"));
    // Two poles at 700 kHz: 20 log10(1 + (700 / 270.2)^2).
    CHECK(contains(shown.output, "(700 kHz) takes 17.74 dB"));
    CHECK(contains(shown.errors, "stock.cfg:4: mysteryCfg: is not known and has no effect"));
}

TEST_CASE("a scene may name a TI command file beside it", "[program][simulate]") {
    const MadeUpFolder folder;
    folder.with("mine.cfg",
                "channelCfg 7 3 0\nchirpComnCfg 20 0 0 128 4 33 0\n"
                "chirpTimingCfg 6 28 0 150 57.5\nframeCfg 2 0 403 2 100 0\n");
    const auto scene =
        folder.with("scene.toml", edited(project_file("scenes/examples/metal_plate.toml"),
                                         "\"iwrl6432boost\"", "\"mine.cfg\""));
    const Ended made = specula_in(folder.path(), {"simulate", scene.string()});
    CHECK(made.errors.find("error") == std::string::npos);
    REQUIRE(made.status == 0);
    const Ended shown = specula_in(folder.path(), {"show", "scene.h5"});
    CHECK(contains(shown.output, "1 frames x 4 chirps x 3 RX x 128 samples"));
}

TEST_CASE("a complex radar's Q travels in the dataset, and calibrate says it takes none",
          "[program][simulate]") {
    const MadeUpFolder folder;
    const auto scene =
        folder.with("scene.toml", edited(project_file("scenes/examples/metal_plate.toml"),
                                         "\"iwrl6432boost\"", "\"iwr6843isk\""));
    REQUIRE(specula_in(folder.path(), {"simulate", scene.string()}).status == 0);
    const Dataset dataset = read_dataset(folder.path() / "scene.h5");
    REQUIRE(dataset.adc_quadrature.size() == dataset.adc.size());
    CHECK(dataset.adc_quadrature != dataset.adc);
    const Ended refused =
        specula_in(folder.path(), {"calibrate", "scene.h5", "--radar", "iwr6843isk"});
    CHECK(refused.status == 2);
    CHECK(contains(refused.errors, "calibration takes real samples only"));
}

TEST_CASE("calibrate refuses a recording that is none", "[program][calibrate]") {
    const MadeUpFolder folder;
    const Ended missing = specula_in(folder.path(), {"calibrate", "nothing.h5"});
    CHECK(missing.status == 2);
    folder.with("scene.toml", project_file("scenes/examples/metal_plate.toml"));
    REQUIRE(specula_in(folder.path(), {"simulate", "scene.toml"}).status == 0);
    const Ended one = specula_in(folder.path(), {"calibrate", "scene.h5"});
    CHECK(one.status == 2);
    CHECK(contains(one.errors, "the recording has 1 chirps; record three or more"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "iwrl6432boost_calibrated.toml"));
}

TEST_CASE("a simulated board can be calibrated and is like itself", "[program][calibrate]") {
    const MadeUpFolder folder;
    const std::string radar =
        edited(project_file("scenes/radars/iwrl6432boost.toml"), "idle_us          = 6 ",
               "idle_us = 100\nchirps_per_frame = 40 ");
    folder.with("board.toml", radar);
    folder.with("scene.toml", edited(project_file("scenes/examples/metal_plate.toml"),
                                     "\"iwrl6432boost\"", "\"board.toml\""));
    REQUIRE(specula_in(folder.path(), {"simulate", "scene.toml"}).status == 0);
    const Ended done = specula_in(folder.path(), {"calibrate", "scene.h5", "--radar", "board.toml",
                                                  "--scene", "scene.toml", "--out", "mine.toml"});
    INFO(done.errors);
    REQUIRE(done.status == 0);
    CHECK(contains(done.output, "gain +0.0") + contains(done.output, "gain -0.0") > 0);
    CHECK(specula_in(folder.path(), {"show", "mine.toml"}).status == 0);
    const Ended alike = specula_in(
        folder.path(), {"likeness", "scene.h5", "--radar", "mine.toml", "--out", "alike"});
    INFO(alike.errors);
    CHECK(alike.status == 0);
    CHECK(contains(alike.output, "within 20 % or one code"));
    CHECK(std::filesystem::exists(folder.path() / "alike/likeness.png"));
}

}  // namespace
}  // namespace specula
