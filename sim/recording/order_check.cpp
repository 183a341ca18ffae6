#include "sim/recording/order_check.hpp"

#include <algorithm>

namespace specula {

namespace {

constexpr std::size_t most_rows = 4096;  ///< chirps looked at; more would not say more

/// Sum of squared differences along the samples, `at(rx, sample)` being the code's place.
template <typename Place>
double roughness(const CodeCube& cube, std::size_t chirp, Place at) {
    const std::int16_t* codes = cube.in_phase.data() + chirp * cube.n_rx * cube.n_samples;
    double sum = 0.0;
    for (std::size_t rx = 0; rx < cube.n_rx; ++rx)
        for (std::size_t n = 1; n < cube.n_samples; ++n) {
            const double step =
                static_cast<double>(codes[at(rx, n)]) - static_cast<double>(codes[at(rx, n - 1)]);
            sum += step * step;
        }
    return sum;
}

}  // namespace

double interleaving_suspicion(const CodeCube& cube) {
    if (cube.n_rx < 2 || cube.n_samples < 2) return 0.0;
    const std::size_t n_rx = cube.n_rx, n_samples = cube.n_samples;
    double as_read = 0.0, interleaved = 0.0, parted = 0.0;
    for (std::size_t chirp = 0; chirp < std::min(most_rows, cube.n_frames * cube.n_chirps);
         ++chirp) {
        as_read += roughness(cube, chirp, [=](auto rx, auto n) { return rx * n_samples + n; });
        interleaved += roughness(cube, chirp, [=](auto rx, auto n) { return n * n_rx + rx; });
        parted += roughness(cube, chirp, [=](auto rx, auto n) {
            const std::size_t place = rx * n_samples + n;
            return place % n_rx * n_samples + place / n_rx;
        });
    }
    const double other = std::min(interleaved, parted);
    return other > 0.0 ? as_read / other : 0.0;
}

}  // namespace specula
