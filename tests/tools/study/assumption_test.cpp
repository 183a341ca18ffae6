#include "tools/study/assumption.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/tools/study/toy_protocol.hpp"
#include "tools/report/paper_agreement.hpp"
#include "tools/study/experiment.hpp"

namespace specula {
namespace {

Experiment toy_of_protocol() {
    static const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    const MadeUpFolder folder;
    return read_experiment(folder.with("toy.toml", toy_protocol()), catalogue);
}

TEST_CASE("an assumption that says nothing changes nothing", "[study]") {
    const Experiment before = toy_of_protocol(), after = under({}, before);
    CHECK(after.radar.receiver.noise_figure_db == before.radar.receiver.noise_figure_db);
    CHECK(after.radar.chirp.slope_hz_s == before.radar.chirp.slope_hz_s);
    CHECK(after.population.session.height_m.spread() ==
          before.population.session.height_m.spread());
    CHECK(after.population.session.gain_db.median() == before.population.session.gain_db.median());
    CHECK(after.training.sessions == before.training.sessions);
    CHECK(after.descriptor.window == before.descriptor.window);
}

TEST_CASE("an assumption changes what it names", "[study]") {
    const Experiment before = toy_of_protocol();
    Assumption assumption;
    assumption.snr_db = 7.0;
    assumption.gain_db = 2.0;
    assumption.clutter_db = 4.0;
    assumption.spread_factor = 3.0;
    assumption.slope_factor = 0.5;
    assumption.size_m = {0.2, 0.1};
    assumption.sessions = 4;
    assumption.first_bin = 3;
    assumption.window = "hann";
    const Experiment after = under(assumption, before);
    CHECK(after.radar.receiver.noise_figure_db ==
          Approx(before.radar.receiver.noise_figure_db - 7.0));
    CHECK(after.population.session.gain_db.median() == Approx(2.0));
    CHECK(after.population.session.gain_db.spread() == Approx(0.9));  // 3 times 0.3 dB
    CHECK(after.population.session.height_m.spread() == Approx(0.006));
    CHECK(after.population.world_clutter.level_db ==
          Approx(before.population.world_clutter.level_db + 4.0));
    CHECK(after.radar.chirp.bin_m() == Approx(2.0 * before.radar.chirp.bin_m()));
    for (const SampleLaw& law : after.population.classes) {
        CHECK(law.nominal.face.size_x_m == 0.2);
        CHECK(law.nominal.face.size_y_m == 0.1);
    }
    CHECK(after.training.sessions * after.training.frames ==
          before.training.sessions * before.training.frames);
    CHECK(after.descriptor.first_bin == 3);
    CHECK(after.descriptor.window == FW_WINDOW_HANN);
}

TEST_CASE("the percentile of a figure is the share of predictions below it", "[study]") {
    const PaperPercentile middle = percentile_of(0.55, {0.9, 0.5, 0.6, 0.4});
    CHECK(middle.percentile == 0.5);
    CHECK(middle.prediction.mean == Approx(0.55));  // the median, between 0.5 and 0.6
    CHECK(percentile_of(0.1, {0.4, 0.5}).percentile == 0.0);
    CHECK(percentile_of(1.0, {0.4, 0.5}).percentile == 1.0);
    // 5th and 95th of 0..100 in steps of one.
    std::vector<double> steps;
    for (int i = 0; i <= 100; ++i) steps.push_back(i);
    CHECK(percentile_of(50.0, steps).prediction.low == Approx(5.0));
    CHECK(percentile_of(50.0, steps).prediction.high == Approx(95.0));
}

}  // namespace
}  // namespace specula
