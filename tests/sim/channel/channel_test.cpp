#include "sim/channel/channel.hpp"

#include "sim/signal/dechirp.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/sim/channel/test_comb.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

struct Piece {
    std::string material;
    std::string backing;
    double thickness_m;
    double roughness_m;
};

Reflector reflector_of_piece(const Piece& piece) {
    Sample sample;
    sample.material = piece.material;
    sample.backing = piece.backing;
    sample.thickness_m = piece.thickness_m;
    sample.roughness_m = piece.roughness_m;
    return reflector_of(sample, library());
}

Scatter scatter_of(const PlateScene& scene) {
    return scene.scatter(test_comb.last_hz());
}

/// Largest distance of the channel from the plain sums over its largest value.
double off_the_plain_sum(const Scatter& scatter, const Reflector& reflector) {
    const Channel channel = channel_of(scatter, {&reflector, 1}, test_comb);
    double off = 0.0, largest = 0.0;
    for (int i = 0; i < test_comb.n; ++i)
        largest = std::max(largest, std::abs(channel.of_rx(0)[i]));
    for (int i = 0; i < test_comb.n; i += 48)
        off = std::max(off, std::abs(channel.of_rx(0)[i] -
                                     direct_sum(scatter, 0, {&reflector, 1}, test_comb.at(i))));
    return off / largest;
}

PlateScene tilted_scene() {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.12, .size_y_m = 0.1, .bow_m = 5e-4};
    scene.pose.height_m = 0.25;
    scene.pose.sample = {0.05, 0.17};
    scene.pattern = PatchPattern{};
    scene.rx_m = {0.012, 0.0024, 0.0};
    return scene;
}

constexpr double promised = 1e-6;  // of channel_of's docstring

TEST_CASE("the moments' channel is the plain sum for every material, rough and backed",
          "[channel]") {
    const Scatter scatter = scatter_of(tilted_scene());
    for (const std::string& name : library().names())
        for (const auto* backing : {"air", "metal", "limestone"})
            for (const bool thick : {false, true}) {
                const Piece piece{name, backing, thick ? 0.018 : 0.003, thick ? 0.0 : 1e-4};
                INFO(name << " on " << backing << (thick ? ", thick" : ", thin and rough"));
                CHECK(off_the_plain_sum(scatter, reflector_of_piece(piece)) < promised);
            }
}

TEST_CASE("a thick sheet of low loss seen over a wide angle takes as many terms as it needs",
          "[channel]") {
    // Its reflection swings many times between the foot and the far edge: 12 terms were wrong by
    // 10 % and more.
    PlateScene scene;
    scene.pose.sample.about_y_rad = 0.6;
    const Scatter scatter = scatter_of(scene);
    for (const auto* backing : {"air", "metal"}) {
        INFO(backing);
        const Reflector sheet = reflector_of_piece({"plexiglass", backing, 0.05, 0.0});
        CHECK(off_the_plain_sum(scatter, sheet) < promised);
    }
}

TEST_CASE("a metre of plexiglass over a wide angle is summed right too", "[channel]") {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.05, .size_y_m = 0.05};
    scene.pose.height_m = 0.05;
    CHECK(off_the_plain_sum(scatter_of(scene), slab({2.6, -1e-4}, 1.0)) < promised);
}

TEST_CASE("the gain of both antennas multiplies the channel", "[channel]") {
    PlateScene scene = tilted_scene();
    const Complex before = scene.transfer(perfect_conductor(), 60e9);
    PatchPattern stronger;
    stronger.gain_dbi += 10.0 * std::log10(2.0);
    scene.pattern = stronger;
    // sqrt(2) per antenna
    CHECK(std::abs(scene.transfer(perfect_conductor(), 60e9) / before - 2.0) < 1e-12);
}

TEST_CASE("a height of half a wavelength more leaves the phase where it was", "[channel]") {
    // Two ways of half a wavelength are a whole turn; the edges' echoes turn by a little less.
    PlateScene scene;
    scene.plate = {.size_x_m = 0.4, .size_y_m = 0.4};
    const double wavelength_m = speed_of_light_m_s / 60e9;
    const Complex before = scene.transfer(perfect_conductor(), 60e9);
    scene.pose.height_m += 0.5 * wavelength_m;
    const Complex after = scene.transfer(perfect_conductor(), 60e9);
    CHECK(std::abs(std::arg(after / before)) < 0.01 * two_pi);
    scene.pose.height_m -= 0.25 * wavelength_m;
    CHECK(std::abs(std::arg(-scene.transfer(perfect_conductor(), 60e9) / before)) < 0.01 * two_pi);
}

TEST_CASE("what is not seen echoes nothing", "[channel]") {
    PlateScene behind;
    behind.pattern = PatchPattern{};
    behind.pose.sensor.about_y_rad = pi;  // looks up: in front of the face, but with its back
    const Reflector mirror = perfect_conductor();
    const Scatter nothing{.n_rx = 1, .routes = {}};
    for (const Scatter& scatter : {scatter_of(behind), nothing}) {
        const Channel channel = channel_of(scatter, {&mirror, 1}, test_comb);
        REQUIRE(channel.h.size() == static_cast<std::size_t>(test_comb.n));
        CHECK(std::all_of(channel.h.begin(), channel.h.end(),
                          [](Complex h) { return h == Complex(0.0); }));
    }
}

TEST_CASE("a comb of one frequency is summed too", "[channel]") {
    const PlateScene scene = tilted_scene();
    const Scatter scatter = scatter_of(scene);
    const Reflector mirror = perfect_conductor();
    const Channel channel = channel_of(scatter, {&mirror, 1}, {60e9, 1e6, 1});
    const Complex expected = direct_sum(scatter, 0, {&mirror, 1}, 60e9);
    CHECK(std::abs(channel.of_rx(0)[0] - expected) < promised * std::abs(expected));
}

TEST_CASE("a comb of few frequencies far apart is summed too", "[channel]") {
    // Its paths differ by many wavelengths of the band: more points to interpolate from than
    // frequencies asked for.
    PlateScene scene;
    scene.plate = {.size_x_m = 0.5, .size_y_m = 0.05};
    scene.pose.height_m = 0.15;
    const FrequencyComb apart{57e9, 5e9, 2};
    const Scatter scatter = scene.scatter(apart.last_hz());
    const Reflector mirror = perfect_conductor();
    const Channel channel = channel_of(scatter, {&mirror, 1}, apart);
    for (int i = 0; i < apart.n; ++i) {
        const Complex expected = direct_sum(scatter, 0, {&mirror, 1}, apart.at(i));
        CHECK(std::abs(channel.of_rx(0)[i] - expected) < promised * std::abs(expected));
    }
}

TEST_CASE("each receiver has its own channel", "[channel]") {
    const PlateScene scene = tilted_scene();
    Radar radar = scene.radar();
    radar.rx = {{.position_m = {0.0, 0.0, 0.0}}, {.position_m = scene.rx_m}};
    const Scatter both = trace(scene.target(), antennas_of(radar, radar_placement(scene.pose)),
                               {.highest_hz = test_comb.last_hz()});
    const Reflector mirror = perfect_conductor();
    const Channel channel = channel_of(both, {&mirror, 1}, test_comb);
    const Complex expected = direct_sum(both, 1, {&mirror, 1}, test_comb.at(7));
    CHECK(std::abs(channel.of_rx(1)[7] - expected) < promised * std::abs(expected));
    CHECK(std::abs(channel.of_rx(0)[7] - expected) > 0.01 * std::abs(expected));
}

}  // namespace
}  // namespace specula
