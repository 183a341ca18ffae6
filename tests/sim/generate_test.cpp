#include "sim/generate.hpp"

#include <set>

#include "sim/dataset/fingerprint.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"
#include "tests/sim/small_bench.hpp"

namespace specula {
namespace {

TEST_CASE("a dataset's file has the same bytes for any number of threads", "[sim]") {
    const SmallBench small;
    const TemporaryFolder folder;
    std::string first;
    for (const int threads : {1, 2, 3}) {
        write_dataset(folder / "a.h5", generate(small.bench(), straight_down(1), 2, threads));
        const std::string bytes = bytes_of(folder / "a.h5");
        if (threads == 1) first = bytes;
        CHECK(bytes == first);
    }
}

TEST_CASE("a session is the same alone, in its dataset, and after any other", "[sim]") {
    const SmallBench small;
    const Bench bench = small.bench();
    const Condition condition = straight_down(2);
    const Dataset dataset = generate(bench, condition, 2, 2);
    const std::size_t per_frame = dataset.codes_per_frame();

    std::size_t row = dataset.n_frames();
    for (int world = 1; world >= 0; --world)  // backwards: the other way round than generate
        for (int label = 4; label >= 0; --label)
            for (int session = 1; session >= 0; --session) {
                const SessionFrames alone =
                    simulate_session(bench, condition, {world, label, session});
                row -= alone.truth.size();
                REQUIRE(std::equal(alone.adc.begin(), alone.adc.end(),
                                   dataset.adc.begin() + static_cast<long>(row * per_frame)));
                for (std::size_t i = 0; i < alone.truth.size(); ++i) {
                    const Truth& found = dataset.truth[row + i];
                    CHECK(found.session == alone.truth[i].session);
                    CHECK(found.world == world);
                    CHECK(found.label == label);
                    CHECK(found.frame == static_cast<int>(i));
                    for (const TruthColumn& column : truth_columns)
                        CHECK(found.*column.member == alone.truth[i].*column.member);
                }
            }
    CHECK(row == 0);
}

TEST_CASE("more sessions or worlds leave those there were untouched", "[sim]") {
    const SmallBench small;
    Condition condition = straight_down(3);
    condition.sessions = 1;
    const Dataset few = generate(small.bench(), condition, 1, 1);
    condition.sessions = 2;
    const Dataset many = generate(small.bench(), condition, 2, 1);
    // Ordered by world, class, session: session 0 of class k is the 2k-th of world 0.
    const std::size_t codes = few.codes_per_frame() * static_cast<std::size_t>(condition.frames);
    for (std::size_t label = 0; label < 5; ++label)
        CHECK(std::equal(few.adc.begin() + static_cast<long>(label * codes),
                         few.adc.begin() + static_cast<long>((label + 1) * codes),
                         many.adc.begin() + static_cast<long>(2 * label * codes)));
}

TEST_CASE("another seed, world, condition or session is another recording", "[sim]") {
    SmallBench small;
    Condition condition = straight_down(1);
    const SessionFrames first = simulate_session(small.bench(), condition, {0, 2, 0});
    CHECK(simulate_session(small.bench(), condition, {0, 2, 0}).adc == first.adc);
    CHECK(simulate_session(small.bench(), condition, {1, 2, 0}).adc != first.adc);
    CHECK(simulate_session(small.bench(), condition, {0, 2, 1}).adc != first.adc);
    CHECK(simulate_session(small.bench(), condition, {0, 3, 0}).adc != first.adc);
    condition.number = 2;
    CHECK(simulate_session(small.bench(), condition, {0, 2, 0}).adc != first.adc);
    condition.number = 1;
    small.seed = 8;
    CHECK(simulate_session(small.bench(), condition, {0, 2, 0}).adc != first.adc);
}

TEST_CASE("a dataset says how it was made and counts its sessions", "[sim]") {
    const SmallBench small;
    const Condition condition = straight_down(1);
    std::atomic<std::size_t> done{0};
    const Dataset dataset = generate(small.bench(), condition, 2, 2, &done);
    CHECK(done == 2u * 5u * 2u);
    CHECK(done == session_count(condition, small.population, 2));
    CHECK(dataset.n_frames() == done * 3);
    CHECK(dataset.adc.size() == dataset.n_frames() * dataset.codes_per_frame());
    CHECK(dataset.class_names == small.population.class_names());
    CHECK(dataset.n_chirps == 1);
    CHECK(dataset.n_rx == 2);
    CHECK(dataset.n_samples == 128);
    CHECK(dataset.origin.condition == "condition_1");
    CHECK(dataset.origin.seed == 7);
    CHECK(dataset.origin.radar == "toy");
    CHECK(dataset.origin.bin_m == Approx(small.radar.chirp.bin_m()));
}

TEST_CASE("no two frames of a study are alike, however they are grouped", "[sim]") {
    const SmallBench small;
    std::set<std::vector<std::int16_t>> seen;
    std::set<std::int32_t> sessions;
    std::size_t n_frames = 0, n_sessions = 0;
    for (const int number : {0, 1, 15}) {
        const Condition condition = straight_down(number);
        const Dataset dataset = generate(small.bench(), condition, 2, 2);
        for (std::size_t i = 0; i < dataset.n_frames(); ++i) {
            const auto* codes = dataset.frame(i).samples;
            seen.insert({codes, codes + dataset.codes_per_frame()});
            sessions.insert(dataset.truth[i].session);
        }
        n_frames += dataset.n_frames();
        n_sessions += session_count(condition, small.population, 2);
    }
    CHECK(seen.size() == n_frames);
    CHECK(sessions.size() == n_sessions);  // numbers are unique in the experiment
}

}  // namespace
}  // namespace specula
