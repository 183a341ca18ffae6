#include "sim/trace/way_packet.hpp"

#include <limits>

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a packet holds the ways that are worked out one by one", "[trace]") {
    Stream stream({.seed = 1, .purpose = "ways"});
    const auto number = [&] { return 2.0 * stream.uniform() - 1.0; };
    OwnFrame frame{.origin_m = {0.3, -0.2, 0.1},
                   .to_own = Eigen::AngleAxisd(0.7, Vector3(0.6, 0.0, 0.8)).toRotationMatrix()};
    const BoundingSphere around{.centre_m = {0.1, 0.0, 0.0}, .radius_m = 0.4};
    for (const double height_m : {0.2, 30.0}) {  // inside the sphere and far above it
        const Vector3 from(0.05, 0.1, height_m);
        std::vector<Vector3> to;
        for (int i = 0; i < 13; ++i) to.push_back({0.3 * number(), 0.3 * number(), 0.1 * number()});
        WayPacket packet;
        make_ways({frame, around, from}, to, packet);
        for (std::size_t i = 0; i < to.size(); ++i) {
            const Way way = way_between(frame.point(from), frame.point(to[i]), around);
            REQUIRE(packet.valid[i] == -1);
            // One rounding to single precision of numbers that agree to double precision.
            CHECK(packet.origin_z[i] == Approx(way.origin.z()).epsilon(2e-7).margin(1e-9));
            CHECK(packet.direction_x[i] == Approx(way.direction.x()).epsilon(2e-7).margin(1e-9));
            CHECK(packet.near_m[i] == static_cast<float>(way.near_m));
            CHECK(packet.far_m[i] == Approx(way.far_m).epsilon(2e-7));
        }
        for (std::size_t i = to.size(); i < packet_size; ++i) CHECK(packet.valid[i] == 0);
    }
}

TEST_CASE("ways of no length or to nowhere are not followed", "[trace]") {
    const OwnFrame frame;
    const BoundingSphere around{.centre_m = Vector3::Zero(), .radius_m = 1.0};
    const Vector3 from(0.0, 0.0, 0.5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    const std::vector<Vector3> to{
        from, {0.0, 0.0, 0.5 - 1e-5}, {nan, 0.0, 0.0}, {endless, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    WayPacket packet;
    make_ways({frame, around, from}, to, packet);
    for (std::size_t i = 0; i + 1 < to.size(); ++i) CHECK(packet.valid[i] == 0);
    CHECK(packet.valid[to.size() - 1] == -1);
}

TEST_CASE("Embree alone sees what our rays see", "[trace]") {
    const Geometry geometry(
        {{{{-0.1, -0.1, 0.0}, {0.1, -0.1, 0.0}, {0.0, 0.1, 0.0}}, {{0, 1, 2}}}});
    const Vector3 from(0.0, 0.0, 1.0);
    std::vector<Vector3> to;
    for (int i = -10; i <= 10; ++i) to.push_back({0.02 * i, 0.0, -1.0});
    std::vector<char> clear(to.size(), 1);
    geometry.shadow(from, to, clear);
    const auto hidden = static_cast<std::size_t>(std::count(clear.begin(), clear.end(), 0));
    CHECK(hidden > 3);
    CHECK(hidden < to.size());
    const auto ready = geometry.made_ready(from, to);
    CHECK(geometry.n_blocked(*ready, true) == hidden);
    CHECK(geometry.n_blocked(*ready, false) == hidden);
}

}  // namespace
}  // namespace specula
