#include "sim/channel/path.hpp"

#include "sim/core/constants.hpp"

namespace specula {

Channel silent_channel(int n_rx, const FrequencyComb& comb) {
    return {.n_rx = n_rx,
            .n_frequencies = comb.n,
            .h = std::vector<Complex>(static_cast<std::size_t>(n_rx) *
                                      static_cast<std::size_t>(comb.n))};
}

void add_path(Channel& channel, const FrequencyComb& comb, const Path& path) {
    Complex* h = channel.of_rx(path.rx);
    for (int i = 0; i < comb.n; ++i) {
        const double turns = comb.at(i) / speed_of_light_m_s * path.length_m;
        h[i] += path.transfer * std::polar(1.0, -two_pi * turns);
    }
}

}  // namespace specula
