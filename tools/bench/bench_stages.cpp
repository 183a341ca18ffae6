#include "sim/clutter.hpp"
#include "sim/simulate.hpp"
#include "sim/speckle_echo.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

constexpr double tilt_rad = 0.09;  // about 5 degrees, so that no symmetry helps

/// The parts of a session of one class, each alone.
class SessionStages {
  public:
    SessionStages(const BenchPlan& plan, const BenchScene& scene, const SampleLaw& law)
        : plan_(plan),
          library_(scene.catalogue.materials),
          scene_(scene.plate(law.name, tilt_rad)) {
        Stream stream({.seed = 1, .purpose = "bench sample"});
        scene_.sample.thickness_m = law.thickness_m.sample(stream);
        scene_.sample.roughness_m = law.roughness_m.sample(stream);
        scene_.sample.correlation_m = law.correlation_m.sample(stream);
        scene_.sample.face.bow_m = law.bow_m.sample(stream);
    }

    /// Adds this class's share of each stage.
    void measure(double share, std::vector<BenchStage>& stages) const {
        const OpenScene open(scene_, library_);
        const RoughBody rough{0, open.reflectors[0], 7};
        std::optional<ThinPlate> plate = ThinPlate::of(open.target, open.antennas, open.settings);
        const SpeckleScene speckle{open.target, open.antennas, open.comb, scene_.solver.accuracy_db,
                                   plate};
        Scatter scatter = trace(open.target, open.antennas, open.settings, plate);
        Scatter cells{.n_rx = scatter.n_rx, .routes = {}};
        add_speckle(cells, speckle, rough);
        const Scatter coherent = scatter;
        scatter.routes.insert(scatter.routes.end(), cells.routes.begin(), cells.routes.end());
        const Channel channel = channel_of(scatter, open.reflectors, open.comb);
        const Channel leak = leakage_channel(scene_.radar, {});
        const ReceiverChain chain(scene_.radar);
        const ReceiverInput input{dechirp(channel, scene_.radar.chirp),
                                  dechirp(leak, scene_.radar.chirp)};
        const auto add = [&](std::size_t stage, const std::function<void()>& work) {
            stages[stage].microseconds += 1e6 * share * seconds_per_call(budget(), work);
        };
        add(0, [&] { OpenScene(scene_, library_); });
        add(1, [&] { trace(open.target, open.antennas, open.settings); });
        add(2, [&] { channel_of(coherent, open.reflectors, open.comb); });
        add(3, [&] {
            Scatter drawn{.n_rx = scatter.n_rx, .routes = {}};
            add_speckle(drawn, speckle, rough);
        });
        add(4, [&] { channel_of(cells, open.reflectors, open.comb); });
        add(5, [&] {
            Channel still = leakage_channel(scene_.radar, {});
            Stream stream({.seed = 1, .purpose = "bench clutter"});
            add_clutter(still, open.comb, {.points = 9, .range_m = Distribution(0.7)}, scene_.radar,
                        1.0, stream);
            dechirp(still, scene_.radar.chirp);
        });
        add(6, [&] { dechirp(channel, scene_.radar.chirp); });
        add(7, [&] {
            Stream noise({.seed = 1, .purpose = "bench noise"});
            chain.receive(input, {}, noise);
        });
    }

  private:
    double budget() const { return 0.2 * plan_.budget_s; }

    const BenchPlan& plan_;
    const Library& library_;
    Scene scene_;
};

}  // namespace

void bench_stages(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    std::vector<BenchStage> stages{
        {.name = "scene"},        {.name = "trace"},
        {.name = "coherent sum"}, {.name = "speckle"},
        {.name = "speckle sum"},  {.name = "leakage, clutter"},
        {.name = "beat"},         {.name = "receive", .per_frame = true}};
    const std::vector<SampleLaw>& classes = scene.experiment.population.classes;
    for (const SampleLaw& law : classes)
        SessionStages(plan, scene, law).measure(1.0 / static_cast<double>(classes.size()), stages);
    report.stages = std::move(stages);
}

}  // namespace specula
