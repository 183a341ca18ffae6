#include "sim/channel/material_channels.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "sim/channel/layer_path.hpp"
#include "sim/signal/dechirp.hpp"
#include "tests/check.hpp"
#include "tests/sim/channel/test_comb.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

Complex permittivity_of(const Json& value) {
    return value.is_array() ? Complex(value[0], value[1]) : Complex(value.get<double>());
}

Backing backing_named(const Json& substrate) {
    if (substrate == "pec") return PerfectConductor{};
    return HalfSpace{{permittivity_of(substrate)}};
}

Reflector stack_of(std::vector<Layer> layers, Backing backing) {
    return [=](double frequency_hz) { return Stack{layers, backing, frequency_hz}; };
}

/// Every different stack of the reference data, by the text that describes it.
std::map<std::string, Reflector> reference_stacks() {
    std::map<std::string, Reflector> stacks;
    const auto points = [](const char* name) {
        std::ifstream file(std::string(SPECULA_SOURCE_DIR "/tests/reference/") + name);
        return Json::parse(file)["points"];
    };
    for (const Json& point : points("M03_slab.json")) {
        const Json& inp = point["inp"];
        stacks.emplace(
            inp["eps"].dump() + " " + inp["d_m"].dump(),
            stack_of({{.medium = {permittivity_of(inp["eps"])}, .thickness_m = inp["d_m"]}},
                     HalfSpace{}));
    }
    for (const Json& point : points("M04_stack.json")) {
        const Json& inp = point["inp"];
        std::vector<Layer> layers;
        for (std::size_t i = 0; i < inp["d_m"].size(); ++i)
            layers.push_back(
                {.medium = {permittivity_of(inp["eps_layers"][i])}, .thickness_m = inp["d_m"][i]});
        stacks.emplace(inp["name"].get<std::string>(),
                       stack_of(layers, backing_named(inp["substrate"])));
    }
    return stacks;
}

PlateScene tilted_wide_scene() {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.15, .size_y_m = 0.12, .bow_m = 5e-4};
    scene.pose.height_m = 0.3;
    scene.pose.sample = {0.05, 0.17};
    scene.pattern = PatchPattern{};
    scene.rx_m = {0.012, 0.0024, 0.0};
    return scene;
}

double largest(const Channel& channel) {
    double most = 0.0;
    for (const Complex& h : channel.h) most = std::max(most, std::abs(h));
    return most;
}

/// Largest distance from the plain sums over the largest value, at some frequencies.
double off_the_plain_sum(const Channel& channel, const Scatter& scatter,
                         const Reflector& reflector) {
    double off = 0.0;
    for (int i = 0; i < test_comb.n; i += 36)
        off = std::max(off, std::abs(channel.of_rx(0)[i] -
                                     direct_sum(scatter, 0, {&reflector, 1}, test_comb.at(i))));
    return off / largest(channel);
}

TEST_CASE("one geometry serves every stack of the reference data", "[channel][materials]") {
    const PlateScene scene = tilted_wide_scene();
    const Scatter scatter =
        trace(scene.target(), scene.antennas(), {.highest_hz = test_comb.last_hz()});
    MaterialChannels geometry(scatter, test_comb);
    const auto stacks = reference_stacks();
    REQUIRE(stacks.size() >= 5);
    for (const auto& [name, reflector] : stacks) {
        INFO(name);
        const Channel channel = geometry.channel({&reflector, 1});
        CHECK(off_the_plain_sum(channel, scatter, reflector) < 1e-6);  // 1e-4 was asked for
        const Channel alone = channel_of(scatter, {&reflector, 1}, test_comb);
        double off = 0.0;  // what the materials before it asked for does not show
        for (std::size_t i = 0; i < alone.h.size(); ++i)
            off = std::max(off, std::abs(alone.h[i] - channel.h[i]));
        CHECK(off < 1e-6 * largest(alone));
    }
}

TEST_CASE("a geometry of few points serves every stack of the reference data",
          "[channel][materials]") {
    const PlateScene scene = tilted_wide_scene();
    const Target target = scene.target();
    const Scatter dense = trace(target, scene.antennas(), {.highest_hz = test_comb.last_hz()});
    const auto stacks = reference_stacks();
    TraceSettings settings{.highest_hz = test_comb.last_hz(), .lowest_hz = test_comb.first_hz};
    for (const auto& [name, reflector] : stacks) {
        INFO(name);
        settings.layer_path_m = layer_path_m(reflector(60e9));
        const Scatter thin = trace(target, scene.antennas(), settings);
        const Channel channel = channel_of(thin, {&reflector, 1}, test_comb);
        CHECK(off_the_plain_sum(channel, dense, reflector) < 1e-3);  // 0.1 dB is 1.2 %
    }
}

TEST_CASE("thickness and coherent roughness are drawn on one geometry", "[channel][materials]") {
    const PlateScene scene = tilted_wide_scene();
    const Scatter scatter =
        trace(scene.target(), scene.antennas(), {.highest_hz = test_comb.last_hz()});
    MaterialChannels geometry(scatter, test_comb);
    for (const double thickness_m : {2e-3, 5e-3, 19e-3, 3e-3})
        for (const double roughness_m : {0.0, 1e-4}) {
            const Reflector reflector = stack_of({{.medium = {Complex(2.6, -0.02)},
                                                   .thickness_m = thickness_m,
                                                   .roughness_m = roughness_m}},
                                                 HalfSpace{});
            CHECK(off_the_plain_sum(geometry.channel({&reflector, 1}), scatter, reflector) < 1e-6);
        }
}

TEST_CASE("layers through which waves go long ask for fine angles, metals for none",
          "[channel][materials]") {
    const auto path_of = [](Complex permittivity, double thickness_m, Backing backing) {
        return layer_path_m(
            stack_of({{.medium = {permittivity}, .thickness_m = thickness_m}}, backing)(60e9));
    };
    CHECK(layer_path_m(Stack{{}, PerfectConductor{}, 60e9}) == 0.0);
    CHECK(path_of({2.6, -0.01}, 0.01, HalfSpace{}) > path_of({2.6, -0.01}, 0.005, HalfSpace{}));
    CHECK(path_of({2.6, -0.01}, 0.01, PerfectConductor{}) >
          path_of({2.6, -0.01}, 0.01, HalfSpace{}));
    CHECK(path_of({2.6, -1.5}, 0.02, HalfSpace{}) == 0.0);  // nothing comes back from its back
    // A whole number of turns.
    const double turns = path_of({2.6, 0.0}, 0.01, HalfSpace{}) / (2.0 * 0.01 / std::sqrt(2.6));
    CHECK(turns == Approx(std::round(turns)));
    CHECK(turns > 1.5);
}

}  // namespace
}  // namespace specula
