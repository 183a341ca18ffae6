#include "tools/likeness/recording_statistics.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("white noise reads its own rms in every bin", "[likeness]") {
    ChirpSeries series{.n_rx = 2, .n_samples = 64, .codes = {}};
    Stream stream({.seed = 3, .purpose = "white"});
    for (int i = 0; i < 400 * 2 * 64; ++i)
        series.codes.push_back(static_cast<std::int16_t>(std::lround(50.0 * stream.normal())));
    const auto noise = noise_per_bin_lsb(series, 1, 0);
    REQUIRE(noise.size() == 32);
    // Each bin is a mean over some 400 / 2 independent triples: 5 % of its rms, four times that.
    for (const double bin : noise) CHECK(bin == Approx(50.0).epsilon(0.2));
    double mean = 0.0;
    for (std::size_t bin = 1; bin < 32; ++bin) mean += noise[bin] / 31.0;
    CHECK(mean == Approx(50.0).epsilon(0.03));
}

TEST_CASE("what stands still or moves in a straight line is no noise", "[likeness]") {
    ChirpSeries series{.n_rx = 1, .n_samples = 64, .codes = {}};
    for (int chirp = 0; chirp < 6; ++chirp)
        for (int n = 0; n < 64; ++n)
            series.codes.push_back(static_cast<std::int16_t>(100 * (n % 7) + 3 * chirp * n));
    for (const double bin : noise_per_bin_lsb(series, 0, 5)) CHECK(bin == 0.0);
}

TEST_CASE("a tone in the middle of a bin reads its amplitude there", "[likeness]") {
    std::vector<double> chirp;
    for (int n = 0; n < 128; ++n) chirp.push_back(70.0 * std::cos(two_pi * 20 * n / 128.0 + 0.4));
    const auto spectrum = amplitude_spectrum_lsb(chirp);
    CHECK(spectrum[20] == Approx(70.0).epsilon(1e-3));  // the window's last sample is its first
    CHECK(spectrum[26] < 0.1);                          // Blackman: 58 dB down outside three bins
}

TEST_CASE("the mean chirp is the mean over chirps, receiver by receiver", "[likeness]") {
    const ChirpSeries series{.n_rx = 2, .n_samples = 2, .codes = {1, 2, 3, 4, 5, 6, 7, 8}};
    CHECK(series.n_chirps() == 2);
    CHECK(series.mean_chirp(0) == std::vector<double>{3.0, 4.0});
    CHECK(series.mean_chirp(1) == std::vector<double>{5.0, 6.0});
    CHECK(series.part(1, 2).mean_chirp(1) == std::vector<double>{7.0, 8.0});
}

}  // namespace
}  // namespace specula
