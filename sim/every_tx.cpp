#include "sim/every_tx.hpp"

namespace specula {

Channel channel_of_every_tx(const Radar& radar,
                            const std::function<Channel(const Radar& one_tx)>& make) {
    Channel all = make(radar.sending_from(0));
    for (int tx = 1; tx < radar.n_tx(); ++tx) {
        const Channel next = make(radar.sending_from(tx));
        all.h.insert(all.h.end(), next.h.begin(), next.h.end());
        all.n_rx += next.n_rx;
    }
    return all;
}

}  // namespace specula
