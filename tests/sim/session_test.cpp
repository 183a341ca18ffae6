#include "sim/session.hpp"

#include <map>
#include <set>

#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/sim/small_bench.hpp"

namespace specula {
namespace {

/// The truth of the first frame of each session, without its codes.
std::vector<Truth> first_frames(const Bench& bench, const Condition& condition, int n_worlds) {
    std::vector<Truth> truth;
    for (int world = 0; world < n_worlds; ++world)
        for (int label = 0; label < 5; ++label)
            for (int session = 0; session < condition.sessions_per_class(); ++session)
                truth.push_back(
                    simulate_session(bench, condition, {world, label, session}).truth[0]);
    return truth;
}

/// Where the draws count and not the echo: flat samples of millimetres, a chirp of 16 samples.
SmallBench quick_bench() {
    SmallBench small;
    for (SampleLaw& law : small.population.classes) {
        law.nominal.face = {.size_x_m = 0.005, .size_y_m = 0.005};
        law.bow_m = 0.0;
    }
    small.radar.chirp.n_samples = 16;
    small.radar.chirp.skip_samples = small.radar.chirp.filter_latency_samples = 0;
    return small;
}

bool same_piece(const Truth& a, const Truth& b) {
    return a.thickness_m == b.thickness_m && a.bow_m == b.bow_m && a.roughness_m == b.roughness_m &&
           a.correlation_m == b.correlation_m && a.permittivity_factor == b.permittivity_factor &&
           a.loss_factor == b.loss_factor;
}

TEST_CASE("a known sample is the same piece in every session and condition of its world", "[sim]") {
    const SmallBench small;
    std::map<std::int32_t, Truth> pieces;
    for (const int number : {0, 3}) {
        for (const Truth& truth : first_frames(small.bench(), straight_down(number), 2)) {
            const auto [known, is_new] = pieces.emplace(truth.sample, truth);
            CHECK(same_piece(known->second, truth));
            CHECK(known->second.world == truth.world);
            CHECK(known->second.label == truth.label);
        }
    }
    CHECK(pieces.size() == 2u * 5u);  // one per class and world, each with a number of its own
    std::set<double> thicknesses;
    for (const auto& [number, truth] : pieces) thicknesses.insert(truth.thickness_m);
    CHECK(thicknesses.size() == pieces.size());
}

TEST_CASE("new samples are another piece in each session and never a known one", "[sim]") {
    const SmallBench small;
    std::vector<Truth> all = first_frames(small.bench(), straight_down(0), 2);
    const std::size_t n_known = 2 * 5;  // of them, each twice
    for (const int number : {1, 2}) {
        Condition condition = straight_down(number);
        condition.new_samples = true;
        const auto more = first_frames(small.bench(), condition, 2);
        all.insert(all.end(), more.begin(), more.end());
    }
    std::set<double> thicknesses;
    std::set<std::int32_t> numbers;
    for (const Truth& truth : all) {
        thicknesses.insert(truth.thickness_m);
        numbers.insert(truth.sample);
    }
    CHECK(thicknesses.size() == n_known + 2 * 2 * 5 * 2);
    CHECK(numbers.size() == thicknesses.size());
}

TEST_CASE("numbers of pieces and sessions stay apart at the ends of what is allowed", "[sim]") {
    const SmallBench small = quick_bench();
    Condition condition = straight_down(Condition::most_conditions - 1);
    condition.new_samples = true;
    condition.sessions = Condition::most_sessions;
    condition.frames = 1;
    const int last = Condition::most_sessions - 1;
    std::set<std::int32_t> pieces, sessions;
    for (const int world : {0, 1, SessionId::most_worlds - 1})
        for (const int label : {0, 4})
            for (const int session : {0, last}) {
                const Truth truth =
                    simulate_session(small.bench(), condition, {world, label, session}).truth[0];
                pieces.insert(truth.sample);
                sessions.insert(truth.session);
                CHECK(truth.sample >= 0);
                CHECK(truth.session >= 0);
            }
    for (const int world : {0, 1})  // known pieces of the next world are the nearest numbers
        pieces.insert(
            simulate_session(small.bench(), straight_down(0), {world, 4, 0}).truth[0].sample);
    CHECK(pieces.size() == 3 * 2 * 2 + 2);
    CHECK(sessions.size() == 3 * 2 * 2);
    CHECK_THROWS_AS(simulate_session(small.bench(), condition, {0, 0, last + 1}), BrokenPromise);
    CHECK_THROWS_AS(simulate_session(small.bench(), condition, {SessionId::most_worlds, 0, 0}),
                    BrokenPromise);
}

/// Largest distance between two samples' distribution functions.
double kolmogorov_smirnov(std::vector<double> a, std::vector<double> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    std::size_t i = 0, j = 0;
    double largest = 0.0;
    while (i < a.size() && j < b.size()) {
        (a[i] <= b[j] ? i : j) += 1;
        const double below_a = static_cast<double>(i) / static_cast<double>(a.size());
        const double below_b = static_cast<double>(j) / static_cast<double>(b.size());
        largest = std::max(largest, std::abs(below_a - below_b));
    }
    return largest;
}

/// 200 placements of each class.
const std::vector<Truth>& many_placements() {
    static const std::vector<Truth> drawn = [] {
        Condition condition = straight_down(1);
        condition.sessions = 200;
        condition.frames = 1;
        return first_frames(quick_bench().bench(), condition, 1);
    }();
    return drawn;
}

TEST_CASE("how a sample is put down does not depend on what it is made of", "[sim]") {
    std::map<std::string, std::vector<std::vector<double>>> drawn;  // column, class
    for (const TruthColumn& column : truth_columns) {
        drawn[column.name].resize(5);
        for (const Truth& frame : many_placements())
            drawn[column.name][frame.label].push_back(frame.*column.member);
    }
    // Two samples of n each of one law differ by more than 1.95 sqrt(2 / n) once in a thousand
    // times; 8 laws and 10 pairs of classes make 80 tests, so 2.4: once in 600 seeds.
    const double allowed = 2.4 * std::sqrt(2.0 / 200.0);
    for (const auto* column : {"height_m", "sample_tilt_x_rad", "sample_tilt_y_rad", "offset_x_m",
                               "offset_y_m", "yaw_rad", "gain_db", "displacement_m"})
        for (std::size_t a = 0; a < 5; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                INFO(column << ", classes " << a << " and " << b);
                CHECK(kolmogorov_smirnov(drawn[column][a], drawn[column][b]) < allowed);
                CHECK(drawn[column][a] != drawn[column][b]);  // and are draws of their own
            }
}

TEST_CASE("placements follow their laws", "[sim]") {
    const auto& truth = many_placements();
    const auto spread = [&](double Truth::*member, double about) {
        double square = 0.0;
        for (const Truth& frame : truth) square += std::pow(frame.*member - about, 2);
        return std::sqrt(square / static_cast<double>(truth.size()));
    };
    // A standard deviation from 1000 draws is good to 1 / sqrt(2000) = 2.2 %; five times that.
    CHECK(spread(&Truth::height_m, 0.45) == Approx(0.002).epsilon(0.11));
    CHECK(spread(&Truth::sample_tilt_x_rad, 0.0) == Approx(0.01).epsilon(0.11));
    CHECK(spread(&Truth::sample_tilt_y_rad, 0.0) == Approx(0.01).epsilon(0.11));
    CHECK(spread(&Truth::offset_x_m, 0.0) == Approx(0.01 / std::sqrt(12.0)).epsilon(0.11));
    CHECK(spread(&Truth::yaw_rad, 0.0) == Approx(0.03).epsilon(0.11));
    CHECK(spread(&Truth::gain_db, 0.0) == Approx(std::hypot(0.3, 0.02)).epsilon(0.11));
    CHECK(spread(&Truth::displacement_m, 0.0) == Approx(3.5e-5).epsilon(0.11));
}

TEST_CASE("no draw makes a piece thinner than nothing", "[sim]") {
    SmallBench small = quick_bench();
    for (SampleLaw& law : small.population.classes) {
        law.thickness_m = Distribution(Distribution::Normal{0.001, 0.002});
        law.loss_factor = Distribution(Distribution::Normal{0.2, 1.0});
    }
    Condition condition = straight_down(1);
    condition.new_samples = true;
    condition.sessions = 20;
    condition.frames = 1;
    for (const Truth& truth : first_frames(small.bench(), condition, 1)) {
        CHECK(truth.thickness_m > 0.0);
        CHECK(truth.roughness_m >= 0.0);
        CHECK(truth.loss_factor > 0.0);
        CHECK(truth.permittivity_factor > 0.0);
    }
}

TEST_CASE("frames of a session share its placement and differ by what a frame may", "[sim]") {
    const SmallBench small;
    const SessionFrames session = simulate_session(small.bench(), straight_down(1), {0, 0, 0});
    REQUIRE(session.truth.size() == 3);
    for (const Truth& truth : session.truth)
        for (const TruthColumn& column : truth_columns) {
            const std::string name = column.name;
            if (name == "gain_db" || name == "displacement_m") continue;
            CHECK(truth.*column.member == session.truth[0].*column.member);
        }
    CHECK(session.truth[0].displacement_m != session.truth[1].displacement_m);
    CHECK(session.truth[0].gain_db != session.truth[1].gain_db);
    CHECK(std::abs(session.truth[0].gain_db - session.truth[1].gain_db) < 0.2);  // 7 of 0.02 dB
}

TEST_CASE("the room is the same in all recordings of a world, but not in another", "[sim]") {
    SmallBench small = quick_bench();
    small.population.session = {};
    small.population.frame = {};
    small.population.session_clutter.points = 0;
    small.population.world_clutter.level_db = 0.0;  // so strong that nothing else counts
    small.radar.receiver.temperature_k = 1e-30;
    for (SampleLaw& law : small.population.classes)
        law.nominal.face = {.size_x_m = 1e-4, .size_y_m = 1e-4};
    const auto codes = [&](int number, const SessionId& id) {
        return simulate_session(small.bench(), straight_down(number), id).adc;
    };
    const auto room = codes(1, {0, 0, 0});
    CHECK(codes(1, {0, 0, 1}) == room);
    CHECK(codes(2, {0, 3, 0}) == room);
    CHECK(codes(1, {1, 0, 0}) != room);
    small.population.session_clutter = small.population.world_clutter;
    CHECK(codes(1, {0, 0, 0}) != codes(1, {0, 0, 1}));
}

}  // namespace
}  // namespace specula
