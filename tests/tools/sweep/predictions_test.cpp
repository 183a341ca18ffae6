#include <atomic>

#include "tests/check.hpp"
#include "tools/sweep/sweep.hpp"

// The sweeps of the documentation against numbers of another program: near-field physical optics on
// a fine grid in numpy, 58 to 62 GHz, one antenna for both ways, rounded to 0.1 dB. Ours averages
// the chirp's 58.0 to 61.9 GHz and has its antennas up to 14 mm apart.

namespace specula {
namespace {

SweepPlan plan_named(const std::string& sweep, const SweepAxes& axes) {
    static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    return read_sweep_plan(catalogue.sweep_file(sweep), axes, catalogue);
}

Sweep predicted(const SweepPlan& plan) {
    static const Library materials(SPECULA_SOURCE_DIR "/materials/library");
    std::atomic<std::size_t> done{0};
    return run_sweep(plan, materials, 2, done);
}

TEST_CASE("the loss by a tilt follows an independent calculation for every size", "[sweep]") {
    const Sweep sweep = predicted(plan_named("tilt_and_size", {.tilt = "5,10,15",
                                                               .tilted = "sample",
                                                               .tilt_plane = "azimuth",
                                                               .size = "100,150,200,300"}));
    const double predicted_db[4][3] = {
        {-1.8, -15.9, -20.9}, {-0.5, -8.1, -19.3}, {-0.6, -0.2, -12.9}, {0.3, 0.4, 0.7}};
    for (std::size_t size = 0; size < 4; ++size)
        for (std::size_t tilt = 0; tilt < 3; ++tilt) {
            INFO("size " << size << ", tilt " << tilt);
            // Far off the foot two rims interfere, and where depends on the band's ends.
            const double margin_db = predicted_db[size][tilt] < -15.0 ? 0.4 : 0.2;
            CHECK(sweep.row({.size = size, .tilt = tilt}).over_untilted_db ==
                  Approx(predicted_db[size][tilt]).margin(margin_db));
        }
}

TEST_CASE("a tilt of the sensor costs what the antenna patterns say", "[sweep]") {
    const Sweep sweep =
        predicted(plan_named("tilt_and_size", {.tilt = "10", .tilted = "sensor", .size = "300"}));
    // Both ways: cos^1.99 in azimuth, cos^6.93 in elevation, at the one angle of the foot.
    CHECK(sweep.row({.tilting = 0}).over_untilted_db == Approx(-0.27).margin(0.02));
    CHECK(sweep.row({.tilting = 1}).over_untilted_db == Approx(-0.92).margin(0.04));
}

TEST_CASE("levels over height follow an independent calculation for every material", "[sweep]") {
    const Sweep sweep = predicted(plan_named("level_over_height", {.height = "350,450,550"}));
    struct Prediction {
        std::size_t specimen;
        double at_350_db, at_550_db, over_mirror_db;
    };
    // Iron and aluminium are both "metal" there; the levels over a mirror are those of wide sheets.
    for (const Prediction& p : {Prediction{0, 2.5, -1.9, 0.0}, Prediction{1, 2.5, -1.9, 0.0},
                                Prediction{2, 2.7, -1.5, -10.7}, Prediction{3, 2.6, -1.6, -15.4},
                                Prediction{4, 2.4, -1.9, -6.1}}) {
        INFO("specimen " << p.specimen);
        CHECK(sweep.row({.specimen = p.specimen, .height = 0}).over_nominal_db ==
              Approx(p.at_350_db).margin(0.25));
        CHECK(sweep.row({.specimen = p.specimen, .height = 2}).over_nominal_db ==
              Approx(p.at_550_db).margin(0.25));
        CHECK(sweep.row({.specimen = p.specimen, .height = 1}).over_mirror_db ==
              Approx(p.over_mirror_db).margin(0.5));  // with the ripple of the rims of 30 cm
    }
    const double apart_db =
        sweep.row({.specimen = 1}).level_db - sweep.row({.specimen = 0}).level_db;
    CHECK(apart_db > 0.003);
    CHECK(apart_db < 0.012);
}

TEST_CASE("roughness takes the tilt out of the level", "[sweep]") {
    const Sweep sweep =
        predicted(plan_named("tilt_and_roughness", {.tilt = "0,10", .size = "150"}));
    const auto loss_db = [&](std::size_t specimen) {
        return sweep.row({.specimen = specimen, .tilt = 1}).over_untilted_db;
    };
    CHECK(loss_db(0) == Approx(-8.0).margin(0.5));  // polished
    CHECK(loss_db(4) > -2.5);                       // 0.8 mm rms over 5 mm
    for (std::size_t specimen = 1; specimen < 5; ++specimen)
        CHECK(loss_db(specimen) > loss_db(specimen - 1));
}

}  // namespace
}  // namespace specula
