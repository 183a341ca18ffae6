#include "sim/clutter.hpp"

#include "sim/signal/dechirp.hpp"
#include "tests/check.hpp"
#include "tests/sim/spectrum.hpp"

namespace specula {
namespace {

const Chirp chirp;
const FrequencyComb comb = comb_of(chirp);

Radar radar_of_two() {
    Radar radar;
    radar.rx = {ReceiveChannel{}, ReceiveChannel{.position_m = {0.01, 0.0, 0.0}}};
    return radar;
}

Channel room(const ClutterLaw& law, std::uint32_t item) {
    const Radar radar = radar_of_two();
    Channel channel = silent_channel(2, comb);
    Stream stream({.seed = 1, .purpose = "clutter", .item = item});
    add_clutter(channel, comb, law, radar, 1e-3, stream);
    return channel;
}

TEST_CASE("a point of the room has the law's mean power and Rayleigh's amplitude", "[sim]") {
    const ClutterLaw law{.points = 1, .level_db = -40.0, .range_m = Distribution(1.0)};
    constexpr int n = 4000;
    double power = 0.0, power_squared = 0.0;
    for (std::uint32_t item = 0; item < n; ++item) {
        const double p = std::norm(room(law, item).of_rx(0)[0]) / 1e-6;  // over the mirror's
        power += p / n;
        power_squared += p * p / n;
    }
    // The power of a complex Gaussian is exponential: as wide as its mean, so n of them are good to
    // 1 / sqrt(n) = 1.6 %, and the mean square, twice the mean's square, to 3.6 %. Five times that.
    CHECK(power == Approx(1e-4).epsilon(0.08));
    CHECK(power_squared / (power * power) == Approx(2.0).epsilon(0.18));
}

TEST_CASE("points of the room add their powers", "[sim]") {
    const ClutterLaw law{.points = 8, .level_db = -40.0,
                         .range_m = Distribution(Distribution::Uniform{0.3, 2.0})};
    constexpr int n = 1000;
    double power = 0.0;
    for (std::uint32_t item = 0; item < n; ++item)
        power += std::norm(room(law, item).of_rx(0)[0]) / 1e-6 / n;
    CHECK(power == Approx(8e-4).epsilon(0.16));  // 1 / sqrt(n) = 3.2 %, five times that
}

TEST_CASE("a point of the room stands at its range, for every receiver from its own place",
          "[sim]") {
    const ClutterLaw law{.points = 1, .level_db = 0.0, .range_m = Distribution(1.0)};
    const Channel channel = room(law, 5);
    const BeatSignal beat = dechirp(channel, chirp);
    std::vector<double> samples;
    for (int i = 0; i < 128; ++i) samples.push_back(beat.of_rx(0)[i].real());
    double strongest = 0.0;
    for (double bin = 5.0; bin < 60.0; bin += 0.05)
        if (amplitude_at(samples, "blackman", bin) > amplitude_at(samples, "blackman", strongest))
            strongest = bin;
    CHECK(strongest == Approx(chirp.bin_of(1.0)).margin(0.1));
    // One amplitude, seen over paths that differ by up to the antennas' 10 mm.
    CHECK(std::abs(channel.of_rx(1)[0]) == Approx(std::abs(channel.of_rx(0)[0])));
    CHECK(channel.of_rx(1)[0] != channel.of_rx(0)[0]);
    const double turned_rad = std::arg(channel.of_rx(1)[144] / channel.of_rx(0)[144] *
                                       std::conj(channel.of_rx(1)[0] / channel.of_rx(0)[0]));
    const double band_hz = comb.last_hz() - comb.first_hz;
    CHECK(std::abs(turned_rad) < two_pi * band_hz / speed_of_light_m_s * 0.01);
}

TEST_CASE("a law of no points is an empty room", "[sim]") {
    const Channel channel = room({.points = 0, .range_m = Distribution(1.0)}, 0);
    for (const Complex h : channel.h) CHECK(h == Complex(0.0));
}

}  // namespace
}  // namespace specula
