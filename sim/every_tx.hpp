#pragma once

#include <functional>

#include "scenes/radar.hpp"
#include "sim/channel/channel.hpp"

namespace specula {

/// The channels of a radar's TX, each made as if it were the only one, in one: the RX of the first
/// TX, then those of the second, and so on.
Channel channel_of_every_tx(const Radar& radar,
                            const std::function<Channel(const Radar& one_tx)>& make);

}  // namespace specula
