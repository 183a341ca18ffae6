#include "tools/serve/rung_cache.hpp"

#include <fstream>

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tools/serve/page_bench.hpp"

namespace specula {
namespace {

/// One world of very few frames: what is kept matters here, not how good it is.
const RungSet& small_set() {
    static const RungSet trained = [] {
        const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
        Experiment experiment = page_experiment(catalogue);
        experiment.training.sessions = 2;
        experiment.training.frames = 4;
        experiment.conditions.resize(1);
        experiment.conditions[0].sessions = 1;
        experiment.conditions[0].frames = 2;
        experiment.full.epochs = 2;
        return train_rungs(experiment, catalogue.materials, 1, {.heights = 2, .tilts = 1});
    }();
    return trained;
}

TEST_CASE("models come back from the cache as they were, for the same origin only", "[serve]") {
    const TemporaryFolder folder;
    const RungCache cache("origin", folder.path());
    CHECK_FALSE(cache.load());
    cache.store(small_set());
    const auto kept = cache.load();
    REQUIRE(kept);
    REQUIRE(kept->rungs.size() == rung_recipes.size());
    std::vector<float> profile(64, 3.0f);
    profile[11] = 500.0f;
    for (std::size_t i = 0; i < kept->rungs.size(); ++i) {
        const RungAnswer before = ask(small_set().rungs[i], profile),
                         after = ask(kept->rungs[i], profile);
        CHECK(before.probability == after.probability);
        CHECK(before.distance_squared == after.distance_squared);
        CHECK(kept->rungs[i].bands[3].high == small_set().rungs[i].bands[3].high);
        CHECK(kept->rungs[i].scores[0].macro_f1 ==
              Approx(small_set().rungs[i].scores[0].macro_f1).epsilon(1e-6));
    }
    CHECK(kept->pieces[2].thickness_mm == small_set().pieces[2].thickness_mm);
    CHECK_FALSE(RungCache("another origin", folder.path()).load());
}

TEST_CASE("a damaged cache is no error but no cache either", "[serve]") {
    const TemporaryFolder folder;
    const RungCache cache("origin", folder.path());
    cache.store(small_set());
    std::ofstream(cache.folder() / "aligned.json") << "{}";
    CHECK_FALSE(cache.load());
    cache.store(small_set());
    std::ofstream(cache.folder() / "set.json") << "{\"rungs\": [";
    CHECK_FALSE(cache.load());
}

TEST_CASE("bands hold nine tenths of what a class showed in training", "[serve]") {
    for (const Rung& rung : small_set().rungs)
        for (const ClassBand& band : rung.bands)
            for (std::size_t k = 0; k < band.low.size(); ++k) {
                CHECK(band.low[k] <= band.middle[k]);
                CHECK(band.middle[k] <= band.high[k]);
            }
}

}  // namespace
}  // namespace specula
