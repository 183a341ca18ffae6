#include "sim/every_tx.hpp"

#include "sim/simulate.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("two TX that change places change places in the channel", "[mimo]") {
    Radar radar;
    radar.tx_position_m = {-6e-3, 0.0, 0.0};
    radar.rx.resize(2);
    radar.rx[1].position_m = {4e-3, 0.0, 0.0};
    radar.further_tx = {{.position_m = {-3e-3, 1e-3, 0.0}}};
    const auto make = [](const Radar& one) {
        Channel channel{.n_rx = 2, .n_frequencies = 1, .h = {}};
        for (const ReceiveChannel& rx : one.rx)
            channel.h.push_back((rx.position_m - one.tx_position_m).norm());
        return channel;
    };
    const Channel there = channel_of_every_tx(radar, make);
    std::swap(radar.tx_position_m, radar.further_tx[0].position_m);
    const Channel back = channel_of_every_tx(radar, make);
    REQUIRE(there.n_rx == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(there.h[i] == back.h[(i + 2) % 4]);
    CHECK(there.h[0] != there.h[2]);
}

TEST_CASE("leakage of one TX only is not heard when another sends", "[mimo]") {
    Radar radar;
    radar.further_tx = {{.position_m = {3e-3, 0.0, 0.0}}};
    radar.leakage = {{.rx = 0, .tx = 1, .range_m = 0.05, .level_dbm = -30.0}};
    const Channel channel = leakage_channel(radar, {});
    REQUIRE(channel.n_rx == 2);
    CHECK(std::abs(channel.of_rx(0)[0]) == 0.0);
    CHECK(std::abs(channel.of_rx(1)[0]) > 0.0);
    radar.leakage[0].tx.reset();
    CHECK(std::abs(leakage_channel(radar, {}).of_rx(0)[0]) > 0.0);
}

}  // namespace
}  // namespace specula
