#include "sim/core/random.hpp"
#include "tests/check.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"

// What must hold of rooms with several bodies, with mirrors and sheets among them, whatever the
// numbers.

namespace specula {
namespace {

constexpr double frequency_hz = 60e9;

/// A metal plate under a sheet of plexiglass, and a wall of triangles beside them.
struct Room {
    Placement motion;
    Pattern pattern = IsotropicPattern{};

    Placement moved(const Placement& p) const {
        return {motion.rotation * p.rotation, motion.rotation * p.shift_m + motion.shift_m};
    }
    std::vector<Body> bodies() const {
        const Placement low{.shift_m = {0.0, 0.0, 0.0}}, high{.shift_m = {0.0, 0.0, 0.1}};
        const Placement wall{Eigen::AngleAxisd(0.5 * pi, Vector3::UnitY()).toRotationMatrix(),
                             {-0.25, 0.0, 0.2}};
        const Plate plate{.size_x_m = 0.1, .size_y_m = 0.1},
            sheet{.size_x_m = 0.3, .size_y_m = 0.3};
        const Mesh beside = triangulate({.size_x_m = 0.5, .size_y_m = 0.5}, moved(wall));
        return {plate_body(plate, moved(low), true, 0.0),
                plate_body(sheet, moved(high), false, 0.005), mesh_body(beside, true, 0.0)};
    }
    AntennaSet antennas() const {
        const PlateScene scene{.plate = {},
                               .pose = {.height_m = 0.45},
                               .pattern = pattern,
                               .tx_m = {-0.006, 0.0, 0.0},
                               .rx_m = {0.008, 0.002, 0.0}};
        return antennas_of(scene.radar(), moved(radar_placement(scene.pose)));
    }
    Scatter scatter() const {
        return trace(Target(bodies()), antennas(),
                     {.highest_hz = frequency_hz, .max_bounces = 2, .edge_currents = true});
    }
    static std::vector<Reflector> reflectors() {
        return {perfect_conductor(), slab({2.6, -0.026}, 0.005), perfect_conductor()};
    }
    Complex echo() const { return direct_sum(scatter(), 0, reflectors(), frequency_hz); }
};

TEST_CASE("a whole room may stand anywhere and be turned any way", "[invariants]") {
    Stream stream({.seed = 5, .purpose = "rooms"});
    const Complex before = Room{}.echo();
    for (int i = 0; i < 3; ++i) {
        const Room room{
            .motion = {Eigen::AngleAxisd(
                           3.0 * stream.uniform(),
                           Vector3(stream.normal(), stream.normal(), stream.normal()).normalized())
                           .toRotationMatrix(),
                       {stream.normal(), stream.normal(), stream.normal()}}};
        CHECK(std::abs(room.echo() - before) < 1e-6 * std::abs(before));
    }
}

TEST_CASE("the room's routes go straight, over the wall and through the sheet", "[invariants]") {
    bool over_wall = false, through_sheet = false, straight = false;
    for (const RouteScatter& route : Room{}.scatter().routes) {
        straight = straight || route.route.n_events() == 0;
        for (const Event& event : route.route.before) {
            over_wall = over_wall || (event.kind == Event::Kind::reflect && event.body == 2);
            through_sheet = through_sheet || event.kind == Event::Kind::transmit;
        }
    }
    CHECK(straight);
    CHECK(over_wall);
    CHECK(through_sheet);
}

TEST_CASE("twice the gain of both antennas is twice the amplitude", "[invariants]") {
    Room room;
    const Complex single = room.echo();
    room.pattern = IsotropicPattern{.gain_dbi = 10.0 * std::log10(2.0)};
    CHECK(std::abs(room.echo() - 2.0 * single) < 1e-12 * std::abs(single));
}

TEST_CASE("half a wavelength higher, a wide plate answers in the same phase", "[invariants]") {
    PlateScene scene;
    scene.plate = {.size_x_m = 1.0, .size_y_m = 1.0};
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    const Complex low = scene.transfer(perfect_conductor(), frequency_hz);
    scene.pose.height_m += 0.5 * wavelength_m;
    const Complex high = scene.transfer(perfect_conductor(), frequency_hz);
    CHECK(std::abs(std::arg(high / low)) < 0.01 * two_pi);
    scene.pose.height_m += 0.25 * wavelength_m;  // and a quarter more turns it round
    const Complex quarter = scene.transfer(perfect_conductor(), frequency_hz);
    CHECK(std::abs(std::arg(-quarter / low)) < 0.01 * two_pi);
}

TEST_CASE("with nothing in the room nothing comes back", "[invariants]") {
    const Scatter scatter =
        trace(Target({}), Room{}.antennas(), {.highest_hz = frequency_hz, .edge_currents = true});
    const Channel channel = channel_of(scatter, {}, {57e9, 1e8, 16});
    REQUIRE(channel.h.size() == 16);
    for (const Complex& h : channel.h) CHECK(h == 0.0);
}

TEST_CASE("from behind a patch antenna nothing comes back", "[invariants]") {
    PlateScene scene;
    scene.pattern = PatchPattern{};
    CHECK(std::abs(scene.transfer(perfect_conductor(), frequency_hz)) > 0.0);
    scene.pose.sensor.about_y_rad = pi;  // it looks at the ceiling
    CHECK(std::abs(scene.transfer(perfect_conductor(), frequency_hz)) == 0.0);
}

TEST_CASE("a metal plate in front takes the echo of what lies behind it, edges and all",
          "[invariants]") {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.1, .size_y_m = 0.1};
    const Mesh front =
        triangulate({.size_x_m = 0.4, .size_y_m = 0.4}, {.shift_m = {0.0, 0.0, 0.2}});
    const TraceSettings settings{
        .highest_hz = frequency_hz, .max_bounces = 1, .edge_currents = true};
    const std::vector<Reflector> both{perfect_conductor(), perfect_conductor()};
    const Complex alone =
        direct_sum(trace(Target({mesh_body(front, true, 0.0)}), scene.antennas(), settings), 0,
                   both, frequency_hz);
    const Complex behind =
        direct_sum(trace(scene.target({front}), scene.antennas(), settings), 0, both, frequency_hz);
    const Complex open =
        direct_sum(trace(scene.target(), scene.antennas(), settings), 0, both, frequency_hz);
    CHECK(std::abs(open) > 0.5 * std::abs(alone));
    CHECK(std::abs(behind - alone) < 1e-9 * std::abs(alone));
}

TEST_CASE("one trace serves any material as well as a trace of its own", "[invariants]") {
    const Room room;
    const Scatter shared = room.scatter();
    const FrequencyComb comb{58e9, 5e8, 5};
    for (const Complex permittivity :
         {Complex(2.6, -0.026), Complex(6.3, -0.26), Complex(1.5, 0.0)}) {
        std::vector<Reflector> reflectors = Room::reflectors();
        reflectors[1] = slab(permittivity, 0.004);
        const Channel reused = channel_of(shared, reflectors, comb);
        const Scatter own = room.scatter();
        for (int i = 0; i < comb.n; i += 2) {
            const Complex direct = direct_sum(own, 0, reflectors, comb.at(i));
            CHECK(std::abs(reused.of_rx(0)[i] - direct) < 1e-6 * std::abs(direct));
        }
    }
}

}  // namespace
}  // namespace specula
