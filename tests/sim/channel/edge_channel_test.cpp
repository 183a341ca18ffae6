#include "sim/channel/edge_channel.hpp"

#include "tests/check.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

TEST_CASE("every metal's edge is that of a perfect conductor, no other material's is", "[edges]") {
    const Library library(SPECULA_SOURCE_DIR "/materials/library");
    CHECK(edge_coefficient({{}, PerfectConductor{}, 60e9}) == 1.0);
    int metals = 0;
    for (const std::string& name : library.names()) {
        const Material& material = *library.find(name);
        const Stack half_space{{}, HalfSpace{material.at(60e9)}, 60e9};
        INFO(name);
        if (material.is_metal()) {
            ++metals;
            CHECK(std::abs(edge_coefficient(half_space) - 1.0) < 0.01);
        } else {
            CHECK(edge_coefficient(half_space) == 0.0);
            for (const double thickness_m : {0.0005, 0.001, 0.003, 0.005, 0.01})
                CHECK(edge_coefficient(
                          {{Layer{.medium = material.at(60e9), .thickness_m = thickness_m}},
                           HalfSpace{},
                           60e9}) == 0.0);
        }
    }
    CHECK(metals >= 2);
}

TEST_CASE("over the chirp edges and faces add up to the plain sum at each frequency", "[edges]") {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.1, .size_y_m = 0.1};
    scene.pose.sample.about_y_rad = 0.17;
    const FrequencyComb comb{57.5e9, 0.25e9, 17};
    const Scatter scatter = trace(scene.target(), scene.antennas(),
                                  {.highest_hz = comb.last_hz(), .edge_currents = true});
    const Reflector mirror = perfect_conductor();
    const Channel channel = channel_of(scatter, {&mirror, 1}, comb);
    Scatter faces = scatter;
    faces.edges.clear();
    for (int i = 0; i < comb.n; i += 4) {
        const Complex plain = direct_sum(scatter, 0, {&mirror, 1}, comb.at(i));
        CHECK(std::abs(channel.of_rx(0)[i] - plain) < 1e-6 * std::abs(plain));
        // Beyond its foot a tilted plate shows its edges: 16 % and more of the echo, not 1e-6.
        CHECK(std::abs(direct_sum(faces, 0, {&mirror, 1}, comb.at(i)) - plain) >
              0.01 * std::abs(plain));
    }
}

TEST_CASE("the edges of a dielectric add nothing", "[edges]") {
    PlateScene scene;
    const Scatter scatter =
        trace(scene.target(), scene.antennas(), {.highest_hz = 60e9, .edge_currents = true});
    const Reflector sheet = slab({2.6, -0.026}, 0.005), mirror = perfect_conductor();
    CHECK(edge_sum(scatter, 0, {&sheet, 1}, 60e9) == 0.0);
    CHECK(std::abs(edge_sum(scatter, 0, {&mirror, 1}, 60e9)) > 0.0);
}

}  // namespace
}  // namespace specula
