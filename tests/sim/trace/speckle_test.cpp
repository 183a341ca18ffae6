#include "sim/trace/speckle.hpp"

#include <cmath>

#include "materials/diffuse.hpp"
#include "sim/channel/diffuse_power.hpp"
#include "tests/check.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

constexpr FrequencyComb one_frequency{.first_hz = test_frequency_hz, .step_hz = 0.0, .n = 1};

Reflector rough_conductor(double roughness_m, double correlation_m) {
    return [=](double at_hz) {
        return Stack{{}, PerfectConductor{roughness_m, correlation_m}, at_hz};
    };
}

PlateScene scene_with(double size_m, double height_m) {
    PlateScene scene;
    scene.plate = {.size_x_m = size_m, .size_y_m = size_m};
    scene.pose.height_m = height_m;
    return scene;
}

RouteScatter cells_in(const PlateScene& scene, double correlation_m = 5e-3) {
    return diffuse_cells(scene.target(), scene.antennas(), {.correlation_m = correlation_m});
}

Complex diffuse_echo(RouteScatter cells, std::uint64_t piece, const Reflector& reflector) {
    Stream stream({.seed = piece, .purpose = "speckle"});
    draw_speckle(cells, stream);
    const Scatter scatter{.n_rx = static_cast<int>(cells.rx.size()), .routes = {cells}};
    return direct_sum(scatter, 0, {&reflector, 1}, test_frequency_hz);
}

/// |E[a b*]| over the root of the powers, and the mean phase between them, over all pieces: cells
/// are independent, so each is its own.
struct Likeness {
    double size, phase_rad;
};
Likeness likeness(const PairScatter& a, const PairScatter& b, const Reflector& reflector) {
    const Stack stack = reflector(test_frequency_hz);
    const auto echo_of = [&](const PairScatter& pair, std::size_t i) {
        const Reflection r = diffuse_reflection(stack, face_of(stack, 0), pair.cos_incidence[i]);
        const double turns = test_frequency_hz / speed_of_light_m_s * pair.path_m[i];
        return (pair.weight[1][i] * r.te + pair.weight[2][i] * r.tm) *
               std::polar(1.0, -two_pi * turns);
    };
    Complex both = 0.0;
    double a_power = 0.0, b_power = 0.0;
    for (std::size_t i = 0; i < a.path_m.size(); ++i) {
        const Complex in_a = echo_of(a, i), in_b = echo_of(b, i);
        both += in_a * std::conj(in_b);
        a_power += std::norm(in_a);
        b_power += std::norm(in_b);
    }
    return {std::abs(both) / std::sqrt(a_power * b_power), std::arg(both)};
}

TEST_CASE("a small rough plate far below returns sigma0 times its area by the radar equation",
          "[speckle]") {
    const double range_m = 4.0, roughness_m = 1e-4, correlation_m = 5e-3;
    PlateScene scene = scene_with(0.06, range_m);
    const Reflector reflector = rough_conductor(roughness_m, correlation_m);
    const double power =
        mean_diffuse_power(cells_in(scene, correlation_m), {&reflector, 1}, one_frequency)[0];
    const double wavelength_m = speed_of_light_m_s / test_frequency_hz, k = two_pi / wavelength_m;
    const double x = std::pow(2.0 * k * roughness_m, 2);
    double series = 0.0, term = std::exp(-x);
    for (int n = 1; n < 30; ++n) {
        term *= x / n;
        series += term * correlation_m * correlation_m / (2.0 * n);
    }
    const double sigma0 = 2.0 * k * k * series;
    // 2 %: the corners of the plate are 0.6 degrees off the axis, where it scatters less.
    CHECK(power == Approx(wavelength_m * wavelength_m * sigma0 * 0.06 * 0.06 /
                          (std::pow(4.0 * pi, 3) * std::pow(range_m, 4)))
                       .epsilon(0.02));
}

TEST_CASE("over many pieces the diffuse power is the mean that is foretold", "[speckle]") {
    const RouteScatter cells = cells_in(scene_with(0.1, 0.45));
    const Reflector reflector = rough_conductor(2e-4, 5e-3);
    const double foretold = mean_diffuse_power(cells, {&reflector, 1}, one_frequency)[0];
    double sum = 0.0;
    for (std::uint64_t piece = 0; piece < 400; ++piece)
        sum += std::norm(diffuse_echo(cells, piece, reflector));
    // Powers are exponentially distributed: the mean of 400 is off by 5 %, rarely by three times.
    CHECK(sum / 400.0 == Approx(foretold).epsilon(0.15));
}

TEST_CASE("speckle stands still with the piece and is another after 5 mm sideways", "[speckle]") {
    // A short correlation lights the whole plate; a long one narrows the spot, and coarser grains
    // of speckle come from it.
    const Reflector reflector = rough_conductor(2e-4, 2e-3);
    const PlateScene still = scene_with(0.3, 0.45);
    const RouteScatter here = cells_in(still, 2e-3);
    const auto echo_here = [&](std::uint64_t piece) {
        return diffuse_echo(here, piece, reflector);
    };
    const auto moved = [&](const Vector3& by_m) {
        PlateScene scene = still;
        scene.pose.offset_x_m = by_m.x();
        scene.pose.offset_y_m = by_m.y();
        scene.pose.height_m -= by_m.z();
        const RouteScatter cells = cells_in(scene, 2e-3);
        return likeness(here.rx[0], cells.rx[0], reflector);
    };
    CHECK(echo_here(3) == diffuse_echo(cells_in(still, 2e-3), 3, reflector));
    CHECK(echo_here(3) != echo_here(4));
    CHECK(moved({0.0, 0.0, 0.0}).size == Approx(1.0));
    CHECK(moved({0.0002, 0.0, 0.0}).size > 0.95);
    CHECK(moved({0.005, 0.0, 0.0}).size < 0.3);
    CHECK(moved({0.0, 0.005, 0.0}).size < 0.3);
    // 30 um nearer, the vibration of a bench, turn all of it by 2k times that.
    const Likeness nearer = moved({0.0, 0.0, 3e-5});
    CHECK(nearer.size > 0.999);
    CHECK(nearer.phase_rad == Approx(-4.0 * pi * test_frequency_hz / speed_of_light_m_s * 3e-5)
                                  .epsilon(0.03));  // cells off the axis turn by their cosine
    CHECK(moved({0.0, 0.0, 0.5 * speed_of_light_m_s / test_frequency_hz}).size > 0.9);
}

TEST_CASE("receivers a few millimetres apart see like speckle, 8 cm apart not", "[speckle]") {
    const PlateScene scene = scene_with(0.2, 0.45);
    AntennaSet antennas = scene.antennas();
    const auto beside = [&](double x_m) {
        PlacedAntenna rx = antennas.rx[0];
        rx.position_m.x() += x_m;
        return rx;
    };
    antennas.rx = {beside(0.0), beside(0.0025), beside(0.08)};
    const RouteScatter cells = diffuse_cells(scene.target(), antennas, {.correlation_m = 5e-3});
    const Reflector reflector = rough_conductor(2e-4, 5e-3);
    CHECK(likeness(cells.rx[0], cells.rx[1], reflector).size > 0.75);
    CHECK(likeness(cells.rx[0], cells.rx[2], reflector).size < 0.3);
}

TEST_CASE("what stands before half of the cells takes half of the diffuse power", "[speckle]") {
    const PlateScene scene = scene_with(0.2, 0.45);
    const Mesh screen{{{0.0, -1.0, 0.2}, {1.0, -1.0, 0.2}, {0.0, 1.0, 0.2}, {1.0, 1.0, 0.2}},
                      {{0, 1, 2}, {1, 3, 2}}};
    const Reflector reflectors[] = {rough_conductor(2e-4, 5e-3), rough_conductor(0.0, 5e-3)};
    const auto power = [&](const std::vector<Mesh>& screens) {
        return mean_diffuse_power(
            diffuse_cells(scene.target(screens), scene.antennas(), {.correlation_m = 5e-3}),
            reflectors, one_frequency)[0];
    };
    CHECK(power({screen}) == Approx(0.5 * power({})).epsilon(0.05));  // a column of 33 cells
}

TEST_CASE("a bowed and tilted piece has the same amplitudes on cells at its own places",
          "[speckle]") {
    PlateScene scene = scene_with(0.1, 0.45);
    const std::size_t n = cells_in(scene).rx[0].path_m.size();
    scene.plate.bow_m = 0.002;
    scene.pose.sample.about_y_rad = 0.2;
    RouteScatter cells = cells_in(scene);
    CHECK(cells.rx[0].path_m.size() == n);
    Stream stream({.seed = 5, .purpose = "speckle"}), same({.seed = 5, .purpose = "speckle"});
    draw_speckle(cells, stream);
    RouteScatter flat = cells_in(scene_with(0.1, 0.45));
    draw_speckle(flat, same);
    CHECK(cells.rx[0].factor == flat.rx[0].factor);
    CHECK(cells.rx[0].factor.size() == n);
}

TEST_CASE("a piece has the same cells however it is turned", "[speckle]") {
    // 50 cells of 6 mm, of which rounding made 49 in one of fourteen turns.
    PlateScene scene = scene_with(0.3, 0.45);
    const std::size_t n = cells_in(scene).rx[0].path_m.size();
    CHECK(n == 50 * 50);
    for (int i = 0; i < 200; ++i) {
        scene.pose.sample.about_x_rad = 0.001 * i;
        scene.pose.sample.about_y_rad = 0.2 - 0.0013 * i;
        scene.pose.yaw_rad = 0.01 * i;
        CHECK(cells_in(scene).rx[0].path_m.size() == n);
    }
}

}  // namespace
}  // namespace specula
