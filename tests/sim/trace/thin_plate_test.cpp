#include "sim/trace/thin_plate.hpp"

#include "sim/channel/channel.hpp"
#include "sim/core/random.hpp"
#include "sim/signal/dechirp.hpp"
#include "sim/trace/gauss_legendre.hpp"
#include "sim/trace/speckle.hpp"
#include "sim/trace/thin_points.hpp"
#include "tests/check.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

const FrequencyComb comb = comb_of(Chirp{});
const TraceSettings narrow{.highest_hz = comb.last_hz(), .lowest_hz = comb.first_hz};

PlateScene plate_scene(double tilt_rad, double bow_m) {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.3, .size_y_m = 0.24, .bow_m = bow_m};
    scene.pose.sample = {0.04, tilt_rad};
    scene.pose.offset_x_m = 0.01;
    scene.pattern = PatchPattern{};
    scene.tx_m = {-0.006, 0.0, 0.0};
    scene.rx_m = {0.006, 0.0024, 0.0};
    return scene;
}

/// Largest distance between the sums of two scatters over the largest sum.
double apart(const Scatter& a, const Scatter& b, const Reflector& reflector) {
    double off = 0.0, most = 0.0;
    for (const int i : {0, comb.n / 2, comb.n - 1}) {
        const Complex of_a = direct_sum(a, 0, {&reflector, 1}, comb.at(i));
        const Complex of_b = direct_sum(b, 0, {&reflector, 1}, comb.at(i));
        off = std::max(off, std::abs(of_a - of_b));
        most = std::max(most, std::abs(of_b));
    }
    return off / most;
}

TEST_CASE("few points give what many give, tilted, bowed and seen from behind", "[trace][thin]") {
    for (const double tilt_rad : {0.0, 0.09, 0.26})
        for (const double bow_m : {0.0, 2e-3, -2e-3})
            for (const bool behind : {false, true}) {
                INFO(tilt_rad << " rad, bow " << bow_m << (behind ? ", from behind" : ""));
                PlateScene scene = plate_scene(tilt_rad, bow_m);
                if (behind) scene.pose.sample.about_x_rad += pi;
                const Target target = scene.target();
                TraceSettings many = narrow;
                many.lowest_hz = 0.0;
                const Scatter thin = trace(target, scene.antennas(), narrow);
                const Scatter dense = trace(target, scene.antennas(), many);
                CHECK(5 * thin.n_points() < dense.n_points());
                // Both keep 0.1 dB, 1.2 %, with room.
                CHECK(apart(thin, dense, perfect_conductor()) < 5e-4);
            }
}

TEST_CASE("the accuracy asked for decides how close few points come", "[trace][thin]") {
    const PlateScene scene = plate_scene(0.17, 1e-3);
    const Target target = scene.target();
    const Scatter converged =
        trace(target, scene.antennas(), {.highest_hz = comb.last_hz(), .accuracy_db = 1e-6});
    double last = 1.0;
    for (const double accuracy_db : {0.3, 0.01, 1e-4}) {
        TraceSettings settings = narrow;
        settings.accuracy_db = accuracy_db;
        const Scatter thin = trace(target, scene.antennas(), settings);
        const double off = apart(thin, converged, perfect_conductor());
        INFO(accuracy_db << " dB asked for, " << off << " kept");
        CHECK(off < std::pow(10.0, accuracy_db / 20.0) - 1.0);
        CHECK(off < last);
        last = off;
    }
}

bool is_thin(const Target& target, const AntennaSet& antennas, const TraceSettings& settings) {
    std::optional<ThinPlate> plate = ThinPlate::of(target, antennas, settings);
    return plate && plate->echo();
}

TEST_CASE("plates that hide themselves, tables and company are traced point by point",
          "[trace][thin]") {
    const PlateScene scene = plate_scene(0.0, 2e-3);
    CHECK(is_thin(scene.target(), scene.antennas(), narrow));
    TraceSettings any = narrow;
    any.lowest_hz = 0.0;
    CHECK_FALSE(is_thin(scene.target(), scene.antennas(), any));

    PlateScene grazing = scene;  // the far side of the dome lies behind its top
    grazing.pose.sample.about_y_rad = 0.5 * pi - 0.01;
    CHECK_FALSE(is_seen_whole({grazing.plate, grazing.plate_placement()}, grazing.antennas()));

    Mesh screen{{{0.5, 0.0, 0.0}, {0.6, 0.0, 0.0}, {0.5, 0.1, 0.0}}, {{0, 1, 2}}};
    CHECK_FALSE(is_thin(scene.target({screen}), scene.antennas(), narrow));

    PlateScene backwards = scene;  // a patch radiates nothing there
    backwards.pose.sensor.about_y_rad = 0.45 * pi;
    CHECK_FALSE(is_thin(backwards.target(), backwards.antennas(), narrow));
}

TEST_CASE("a way in layers of any length asks for no more thin points than can be counted",
          "[trace][thin]") {
    const PlateScene scene = plate_scene(0.17, 0.0);
    const Target target = scene.target();
    const AntennaSet antennas = scene.antennas();
    TraceSettings long_way = narrow;
    for (const double path_m : {1.0, 30.0, 600.0, 1e4, 1e7}) {
        long_way.layer_path_m = path_m;
        std::optional<ThinPlate> plate = ThinPlate::of(target, antennas, long_way);
        REQUIRE(plate.has_value());
        CHECK(plate->counts().thin.u <= 4096);
        CHECK(plate->counts().thin.v <= 4096);
        if (path_m > 1.0) CHECK_FALSE(plate->echo());
    }
}

TEST_CASE("a weight of few points is the sum over many of phase times a polynomial",
          "[trace][thin]") {
    const PlateScene scene = plate_scene(0.1, 1e-3);
    const PlateSurface plate{scene.plate, scene.plate_placement()};
    const PhaseCentres centres{{0.0, 0.0, 0.45}, {0.02, 0.01, 0.45}};
    constexpr double k_rad_m = 900.0;
    const auto smooth = [](double u, double v) { return 1.0 + u * v * v - 0.3 * u * u * u; };
    const ThinPoints thin = ThinPoints::of_patch(plate, {}, {.dense = {60, 50}, .thin = {7, 6}});
    const auto weights = thin.weights(centres, k_rad_m);
    REQUIRE(weights.size() == 42);
    std::complex<double> few = 0.0;
    std::size_t node = 0;
    for (const double v : ChebyshevGrid{-1.0, 1.0, 6}.nodes())
        for (const double u : ChebyshevGrid{-1.0, 1.0, 7}.nodes())
            few += weights[node++] * smooth(u, v);
    std::complex<double> many = 0.0;
    const GaussRule &rule_u = gauss_legendre(60), &rule_v = gauss_legendre(50);
    for (std::size_t i = 0; i < rule_u.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule_v.nodes.size(); ++j) {
            const double u = rule_u.nodes[i], v = rule_v.nodes[j];
            const Vector3 point = plate.at(u, v).point_m;
            const double path_m = (point - centres.source_m).norm() + (point - centres.rx_m).norm();
            many += rule_u.weights[i] * rule_v.weights[j] * smooth(u, v) *
                    std::polar(1.0, -k_rad_m * path_m);
        }
    // Exact for polynomials of these degrees; rounding of a phase of 900 rad.
    CHECK(std::abs(few - many) < 1e-11);
}

TEST_CASE("cells in few points echo as each of them by itself", "[trace][thin][speckle]") {
    for (const double tilt_rad : {0.0, 0.2}) {
        const PlateScene scene = plate_scene(tilt_rad, 1e-3);
        const Target target = scene.target();
        const RoughLayer layer{.body = 0, .face = 0, .correlation_m = 2e-3};
        const StreamKey piece{.seed = 5, .purpose = "speckle"};
        Stream for_thin(piece), for_cells(piece);
        const AntennaSet antennas = scene.antennas();
        std::optional<ThinPlate> plate = ThinPlate::of(target, antennas, narrow);
        REQUIRE(plate.has_value());
        const auto thin = drawn_thin_cells(*plate, layer, for_thin);
        REQUIRE(thin.has_value());
        RouteScatter cells = diffuse_cells(target, scene.antennas(), layer);
        draw_speckle(cells, for_cells);
        CHECK(for_thin.bits() == for_cells.bits());
        CHECK(3 * thin->rx[0].path_m.size() < cells.rx[0].path_m.size());
        const Reflector rough = [](double at_hz) {
            return Stack{{}, PerfectConductor{2e-4, 2e-3}, at_hz};
        };
        // 0.1 dB, 1.2 %, was asked for.
        CHECK(apart({.n_rx = 1, .routes = {*thin}}, {.n_rx = 1, .routes = {cells}}, rough) < 5e-3);
    }
}

}  // namespace
}  // namespace specula
