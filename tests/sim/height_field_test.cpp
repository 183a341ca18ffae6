#include "sim/height_field.hpp"

#include <cmath>

#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"

namespace specula {
namespace {

Mesh drawn(const Plate& plate, std::uint64_t seed) {
    Stream piece({.seed = seed, .purpose = "heights"});
    return height_field(plate, {2e-4, 5e-3}, piece);
}

TEST_CASE("a height field has the rms height and the correlation asked for", "[speckle]") {
    const Plate plate{.size_x_m = 0.2, .size_y_m = 0.1};
    double squares = 0.0, apart = 0.0, n = 0.0;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Mesh mesh = drawn(plate, seed);
        const std::size_t columns = 201;
        REQUIRE(mesh.vertices_m.size() == columns * 101);
        for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
            if (i % columns + 5 >= columns) continue;
            squares += std::pow(mesh.vertices_m[i].z(), 2);
            apart += mesh.vertices_m[i].z() * mesh.vertices_m[i + 5].z();
            n += 1.0;
        }
    }
    // 5 * 0.2 * 0.1 m^2 hold about 2500 independent spots: 3 % in power, twice that.
    CHECK(std::sqrt(squares / n) == Approx(2e-4).epsilon(0.03));
    CHECK(apart / squares == Approx(std::exp(-1.0)).margin(0.06));
}

TEST_CASE("height fields echo as the statistics of their heights foretell", "[speckle]") {
    Scene scene;
    scene.radar.chirp.n_samples = 2;
    scene.radar.rx = {ReceiveChannel{}};
    scene.sample.material = "aluminium";
    scene.sample.face = {.size_x_m = 0.05, .size_y_m = 0.05};
    scene.sample.roughness_m = 2e-4;
    scene.sample.correlation_m = 5e-3;
    const MeanEcho mean = mean_echo(scene, library());
    scene.solver.roughness = Solver::Roughness::height_field;
    constexpr int n = 24;
    Complex sum = 0.0;
    double power = 0.0;
    for (int i = 0; i < n; ++i) {
        scene.sample.piece = static_cast<std::uint64_t>(i);
        const Complex h = echo_channel(scene, library()).h[0];
        sum += h;
        power += std::norm(h - mean.coherent.h[0]);
    }
    // 24 pieces: 20 % in power; twice that. Kirchhoff's series itself is good to 0.5 dB.
    CHECK(power / n == Approx(mean.diffuse_power[0]).epsilon(0.5));
    CHECK(std::abs(sum / double(n) - mean.coherent.h[0]) <
          2.5 * std::sqrt(mean.diffuse_power[0] / n));
}

TEST_CASE("a height field belongs to its piece, and none is too large to be refused", "[speckle]") {
    Scene scene;
    scene.sample.face = {.size_x_m = 0.02, .size_y_m = 0.02};
    scene.sample.roughness_m = 1e-4;
    const auto top = [&](std::uint64_t number) {
        scene.sample.piece = number;
        return with_height_field(scene).sample.mesh->vertices_m[17].z();
    };
    CHECK(top(1) == top(1));
    CHECK(top(1) != top(2));
    CHECK(with_height_field(scene).sample.roughness_m == 0.0);
    scene.sample.correlation_m = 1e-5;
    CHECK_THROWS(with_height_field(scene));
    scene.sample.roughness_m = 0.0;
    CHECK(!with_height_field(scene).sample.mesh);
}

}  // namespace
}  // namespace specula
