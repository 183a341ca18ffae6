#include "tools/sweep/sweep.hpp"

#include "scenes/scene.hpp"
#include "sim/channel/reflector.hpp"
#include "sim/core/literals.hpp"
#include "sim/signal/dechirp.hpp"
#include "sim/trace/trace.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/sweep/sweep_figures.hpp"
#include "tools/sweep/sweep_table.hpp"

namespace specula {
namespace {

using namespace literals;

SweepPlan plan_of(const SweepAxes& axes, const std::string& scene = "metal_plate") {
    return read_sweep_plan(SPECULA_SOURCE_DIR "/scenes/examples/" + scene + ".toml", axes,
                           catalogue());
}

Sweep swept(const SweepPlan& plan, int threads = 1) {
    std::atomic<std::size_t> done{0};
    Sweep sweep = run_sweep(plan, catalogue().materials, threads, done);
    CHECK(done == n_traces(plan));
    return sweep;
}

/// Mean power by the plain sum at every frequency of a band; nothing of the sweep is used.
double plain_level_db(const Scene& scene, const FrequencyComb& comb) {
    const Target target({plate_body(scene.sample.face, sample_placement(scene.pose), true, 0.0)});
    const Scatter scatter = trace(target, antennas_of(scene.radar, radar_placement(scene.pose)),
                                  {.highest_hz = comb.last_hz()});
    const Reflector reflector = reflector_of(scene.sample, catalogue().materials);
    double power = 0.0;
    int n = 0;
    for (int i = 0; i < comb.n; ++i)
        for (int rx = 0; rx < scatter.n_rx; ++rx, ++n)
            power += std::norm(direct_sum(scatter, rx, {&reflector, 1}, comb.at(i)));
    return 10.0 * std::log10(power / n);
}

TEST_CASE("a level of a sweep is the plain surface integral of the scene it stands for",
          "[sweep]") {
    const Sweep sweep = swept(plan_of({.tilt = "7",
                                       .tilted = "sample",
                                       .tilt_plane = "elevation",
                                       .height = "400",
                                       .material = "plexiglass",
                                       .size = "60",
                                       .thickness = "5"}));
    REQUIRE(sweep.rows.size() == 1);
    Scene scene = read_scene(SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml", catalogue());
    scene.sample.material = "plexiglass";
    scene.sample.thickness_m = 5.0_mm;
    scene.sample.face.size_x_m = scene.sample.face.size_y_m = 60.0_mm;
    scene.pose.height_m = 400.0_mm;
    scene.pose.sample.about_x_rad = 7.0_deg;
    const Chirp& chirp = scene.radar.chirp;
    const FrequencyComb kept{chirp.frequency_hz(0), chirp.frequency_hz(1) - chirp.frequency_hz(0),
                             chirp.n_samples};
    // The same points, so only the interpolation over frequency and angle differs: 1e-6.
    CHECK(sweep.rows[0].level_db == Approx(plain_level_db(scene, kept)).margin(1e-4));
}

TEST_CASE("a wide metal sample reads the infinite mirror, at every height", "[sweep]") {
    const Sweep sweep = swept(plan_of({.height = "350,550", .size = "400"}));
    // The rim of 40 cm leaves a ripple of a tenth of a decibel after the mean over the chirp.
    for (const SweepRow& row : sweep.rows) CHECK(row.over_mirror_db == Approx(0.0).margin(0.2));
    const double image_db = 20.0 * std::log10(350.0 / 550.0);
    CHECK(sweep.rows[1].level_db - sweep.rows[0].level_db == Approx(image_db).margin(0.3));
    CHECK(sweep.rows[1].over_nominal_db - sweep.rows[0].over_nominal_db ==
          Approx(sweep.rows[1].level_db - sweep.rows[0].level_db).margin(1e-9));
}

TEST_CASE("the echo stands in the bin of its height", "[sweep]") {
    const SweepPlan plan = plan_of({.height = "350,450,550"});
    const Sweep sweep = swept(plan);
    for (const SweepRow& row : sweep.rows) {
        const double bin = plan.scene.radar.chirp.bin_of(plan.heights_m[row.at.height]);
        CHECK(row.centroid_bin == Approx(bin).margin(0.1));  // rim and spacing of the antennas
        CHECK(std::abs(row.peak_bin - bin) < 0.6);
        REQUIRE(row.bin_lsb.size() == 12);
    }
}

TEST_CASE(
    "a tilted sample of 15 cm loses the mirror's echo, one of 30 cm and a tilted sensor do not",
    "[sweep]") {
    const Sweep sweep =
        swept(plan_of({.tilt = "0,10", .tilted = "sample,sensor", .size = "150,300"}));
    const auto loss_db = [&](std::size_t size, std::size_t tilting) {
        return sweep.row({.size = size, .tilting = tilting, .tilt = 1}).over_untilted_db;
    };
    CHECK(loss_db(0, 0) < -6.0);
    CHECK(loss_db(1, 0) > -1.5);
    CHECK(loss_db(0, 1) == Approx(loss_db(1, 1)).margin(0.05));  // the foot stays where it is
    CHECK(loss_db(1, 1) > -0.5);
    for (const std::size_t size : {0u, 1u})
        for (const std::size_t tilting : {0u, 1u})
            CHECK(sweep.row({.size = size, .tilting = tilting}).over_untilted_db == 0.0);
    CHECK(n_traces(sweep.plan) == 6);  // untilted, both ways to tilt are one geometry
}

TEST_CASE("a sweep gives the same numbers for any number of threads", "[sweep]") {
    const SweepPlan plan = plan_of({.tilt = "0:6:3", .height = "400:450:25", .size = "60"});
    CHECK(sweep_csv(swept(plan, 1)) == sweep_csv(swept(plan, 3)));
}

TEST_CASE("with frequencies a level stands at each of them, and no bins", "[sweep]") {
    const Sweep sweep = swept(plan_of(
        {.frequency = "58:62:2", .material = "plexiglass", .size = "80", .thickness = "3"}));
    REQUIRE(sweep.rows.size() == 3);
    CHECK(sweep_csv(sweep).find("frequency_ghz") != std::string::npos);
    CHECK(sweep_csv(sweep).find("peak_bin") == std::string::npos);
    // 3 mm of plexiglass are half a wave thick at 62 GHz: interference hides the sheet.
    CHECK(sweep.rows[2].over_mirror_db < sweep.rows[0].over_mirror_db - 3.0);
    CHECK(swept(plan_of({.frequency = "60", .size = "80"})).rows.size() == 1);
}

TEST_CASE("the table comes back from HDF5 as it was", "[sweep]") {
    const TemporaryFolder folder;
    const Sweep sweep =
        swept(plan_of({.tilt = "0,5", .material = "iron,plexiglass", .size = "50"}));
    write_sweep_hdf5(folder / "table.h5", sweep);
    REQUIRE(is_sweep_hdf5(folder / "table.h5"));
    const StoredSweep stored = read_sweep_hdf5(folder / "table.h5");
    const std::vector<SweepColumn> columns = sweep_columns(sweep);
    REQUIRE(stored.columns.size() == columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        CHECK(stored.columns[i].name == columns[i].name);
        CHECK(stored.columns[i].unit == columns[i].unit);
        CHECK(stored.columns[i].values == columns[i].values);
    }
    CHECK(stored.specimens == std::vector<std::string>{"iron", "plexiglass"});
}

TEST_CASE("every axis of several values is drawn", "[sweep]") {
    const Sweep sweep = swept(plan_of({.tilt = "0,5", .height = "400,450", .size = "50"}));
    const SweepFigures drawn = sweep_figures(sweep);
    REQUIRE(drawn.figures.size() == 2);
    CHECK(drawn.figures[0].name == "level_over_height");
    CHECK(drawn.figures[1].name == "level_over_tilt");
    const std::string svg = render_figure(drawn.figures[0]).svg;
    CHECK(svg.find("received power (dBm)") != std::string::npos);
    CHECK(svg.find("dashed: infinite mirror") != std::string::npos);
}

TEST_CASE("a sweep that cannot be is refused before anything is simulated", "[sweep]") {
    const auto complaint = [](const SweepAxes& axes, const std::string& scene = "metal_plate") {
        return message_of([&] { return plan_of(axes, scene); });
    };
    CHECK(complaint({.height = "50"}).find("among bins 0 to 2") != std::string::npos);
    CHECK(complaint({.height = "450:5000:50"}).find("is beyond the farthest range") !=
          std::string::npos);
    CHECK(complaint({.tilt = "80", .tilted = "sample", .size = "1000"})
              .find("the antennas are at 450 mm; keep 30 mm between them") != std::string::npos);
    CHECK(complaint({.tilt = "0:85:0.01", .height = "200:700:1"}).find("use larger steps") !=
          std::string::npos);
    CHECK(complaint({.material = "plexiglas"}) ==
          "--material = plexiglas: no such choice as \"plexiglas\"; did you mean plexiglass?");
    CHECK(complaint({.tilted = "table"}).find("use \"sample\" or \"sensor\"") != std::string::npos);
    CHECK(complaint({.frequency = "58,60,61"}).find("the steps between frequencies differ") !=
          std::string::npos);
    CHECK(complaint({.thickness = "5"}, "rusty_iron").find("has layers") != std::string::npos);
    CHECK(complaint({.roughness = "3000"}).find("use values from 0 up to 2000 um") !=
          std::string::npos);
}

TEST_CASE("every sweep of the catalogue can be read", "[sweep]") {
    for (const std::string& name : catalogue().sweep_names()) {
        INFO(name);
        const SweepPlan plan = read_sweep_plan(catalogue().sweep_file(name), {}, catalogue());
        CHECK(plan.n_rows() > 100);
        CHECK_FALSE(plan.title.empty());
    }
}

TEST_CASE("a sweep file names the key that is wrong", "[sweep]") {
    const MadeUpFolder folder;
    folder.with("plate.toml", project_file("scenes/examples/metal_plate.toml"));
    const auto complaint = [&](const std::string& more) {
        const auto file =
            folder.with("s.toml", "title = \"t\"\nscene = \"plate.toml\"\n" + more + "\n");
        return message_of([&] { return read_sweep_plan(file, {}, catalogue()); });
    };
    CHECK(
        complaint("tilt_deg = \"5:0:1\"").find("s.toml:3: tilt_deg = \"5:0:1\": runs backwards") !=
        std::string::npos);
    CHECK(complaint("tilt_mm = \"5\"").find("s.toml:3: tilt_mm") != std::string::npos);
    CHECK(complaint("[[specimen]]\nmaterial = \"irn\"\nthickness_mm = 3").find("iron") !=
          std::string::npos);
    folder.with("plate.toml", "");
    CHECK(complaint("") != "(no error)");
}

}  // namespace
}  // namespace specula
