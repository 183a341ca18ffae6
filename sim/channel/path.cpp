#include "sim/channel/path.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/kernels.hpp"

namespace specula {

Channel silent_channel(int n_rx, const FrequencyComb& comb) {
    return {.n_rx = n_rx,
            .n_frequencies = comb.n,
            .h = std::vector<Complex>(static_cast<std::size_t>(n_rx) *
                                      static_cast<std::size_t>(comb.n))};
}

void add_path(Channel& channel, const FrequencyComb& comb, const Path& path) {
    const auto n = static_cast<std::size_t>(comb.n);
    std::vector<double> turns(n), cosine(n), sine(n);
    for (std::size_t i = 0; i < n; ++i)
        turns[i] = -comb.at(static_cast<int>(i)) / speed_of_light_m_s * path.length_m;
    kernels().turn(turns.data(), n, cosine.data(), sine.data());
    Complex* h = channel.of_rx(path.rx);
    const double re = path.transfer.real(), im = path.transfer.imag();
    for (std::size_t i = 0; i < n; ++i)
        h[i] += Complex(re * cosine[i] - im * sine[i], re * sine[i] + im * cosine[i]);
}

}  // namespace specula
