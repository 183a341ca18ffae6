#include "sim/signal/dechirp.hpp"

#include "sim/channel/path.hpp"
#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/spectrum.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

/// The chirp of the F cases: B swept in N samples, no settling.
Chirp chirp_of(double first_hz, double bandwidth_hz, int n, double rate_hz) {
    Chirp chirp;
    chirp.start_hz = first_hz;
    chirp.slope_hz_s = bandwidth_hz * rate_hz / n;
    chirp.sample_rate_hz = rate_hz;
    chirp.n_samples = n;
    chirp.skip_samples = chirp.filter_latency_samples = 0;
    return chirp;
}

/// The real beat of one reflector at a range, as the mixer delivers it.
std::vector<double> beat_of(const Chirp& chirp, double range_m, Complex transfer = 1.0) {
    const FrequencyComb comb = comb_of(chirp);
    Channel channel = silent_channel(1, comb);
    add_path(channel, comb, {.length_m = 2.0 * range_m, .transfer = transfer});
    channel.reference_path_m = 2.0 * range_m;
    const BeatSignal beat = dechirp(channel, chirp);
    std::vector<double> samples;
    for (int i = 0; i < beat.n_samples; ++i) samples.push_back(beat.of_rx(0)[i].real());
    return samples;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
}

TEST_CASE("the beat of a path is what mixing the two chirps gives", "[signal]") {
    const Chirp chirp;  // 17 settling samples, 128 kept
    const FrequencyComb comb = comb_of(chirp);
    for (const double range_m : {0.02, 0.45, 1.7, 5.0}) {
        const Complex transfer = std::polar(0.3, 0.8);
        const auto found = beat_of(chirp, range_m, transfer);
        const double tau_s = 2.0 * range_m / speed_of_light_m_s;
        double off = 0.0;
        for (int i = 0; i < comb.n; ++i) {
            // Sent: phase 2 pi (f0 t + S t^2 / 2). Received: the same, tau ago, times the transfer.
            const double t_s = i / chirp.sample_rate_hz;
            const double turns = chirp.start_hz * tau_s + chirp.slope_hz_s * tau_s * t_s -
                                 0.5 * chirp.slope_hz_s * tau_s * tau_s;
            const double mixed = 0.3 * std::cos(two_pi * std::fmod(turns, 1.0) - 0.8);
            off = std::max(off, std::abs(found[static_cast<std::size_t>(i)] - mixed));
        }
        INFO("range " << range_m);
        CHECK(off < 1e-11);  // rounding of up to 2000 turns: 2000 * 2 pi * 1e-16; 1e-12 seen
    }
}

TEST_CASE("the comb starts with the ramp and holds the frequency of every sample", "[signal]") {
    const Chirp chirp;
    const FrequencyComb comb = comb_of(chirp);
    CHECK(comb.n == chirp.settle_samples() + chirp.n_samples);
    CHECK(comb.first_hz == chirp.start_hz);
    for (const int n : {0, 64, 127})
        CHECK(comb.at(chirp.settle_samples() + n) == Approx(chirp.frequency_hz(n)).epsilon(1e-15));
}

TEST_CASE("one residual phase for all paths is off by less than a milliradian over a plate",
          "[signal]") {
    // 30 cm at 45 cm: from the foot to a corner, and halfway between as dechirp takes it.
    const Chirp chirp;
    const double shortest_m = 0.9, longest_m = 2.0 * std::hypot(0.15, 0.15, 0.45);
    const auto residual_rad = [&](double path_m) {
        const double tau_s = path_m / speed_of_light_m_s;
        return pi * chirp.slope_hz_s * tau_s * tau_s;
    };
    const double middle_rad = residual_rad(0.5 * (shortest_m + longest_m));
    CHECK(std::abs(residual_rad(shortest_m) - middle_rad) < 1e-3);
    CHECK(std::abs(residual_rad(longest_m) - middle_rad) < 1e-3);
}

TEST_CASE("a reflector's bins are those of its range, in every window", "[signal][reference]") {
    const Json reference = reference_case("F01_range_bin");
    const double near_db = reference["tolerance"]["db_above_minus60"];
    const double far_db = reference["tolerance"]["db_below_minus60"];
    for (const Json& point : reference["points"]) {
        const Json& inp = point["inp"];
        const Json& expect = point["expect"];
        const Chirp chirp = chirp_of(inp["f0_hz"], inp["B_hz"], inp["N"], inp["fs_hz"]);
        const double range_m = inp["R_m"];
        CHECK(chirp.beat_hz(range_m) == Approx(expect["f_beat_hz"].get<double>()).epsilon(1e-9));
        CHECK(chirp.bin_of(range_m) ==
              Approx(expect["fractional_bin"].get<double>()).epsilon(1e-9));
        const auto beat = beat_of(chirp, range_m);
        for (const std::string window : {"rect", "hann", "blackman"}) {
            const Json& bins = expect["bins_4_to_20_db_" + window];
            for (std::size_t k = 0; k < bins.size(); ++k) {
                const double expected_db = bins[k];
                const double found_db =
                    decibel(amplitude_at(beat, window, static_cast<double>(k) + 4.0));
                INFO(range_m << " m, " << window << ", bin " << k + 4);
                CHECK(std::abs(found_db - expected_db) < (expected_db > -60.0 ? near_db : far_db));
                // Both evaluate the same formula in double: only rounding differs, at -120 dB and
                // below it would show.
                CHECK(std::abs(found_db - expected_db) < 1e-4);
            }
        }
    }
}

TEST_CASE("two reflectors part when they are two bins apart, not when they share one",
          "[signal][reference]") {
    const Json reference = reference_case("F04_two_targets");
    const double allowed = reference["tolerance"]["native_bins_abs"];
    const double allowed_m = reference["tolerance"]["peak_range_m"];
    for (const Json& point : reference["points"]) {
        const Json& inp = point["inp"];
        const Json& expect = point["expect"];
        const Chirp chirp = chirp_of(inp["f0_hz"], inp["B_hz"], inp["N"], inp["fs_hz"]);
        const double first_m = inp["R1_m"], apart_m = inp["separation_m"];
        const auto beat = sum(beat_of(chirp, first_m), beat_of(chirp, first_m + apart_m));
        for (const std::string window : {"rect", "hann"}) {
            INFO(apart_m << " m apart, " << window);
            const Json& bins = expect["X_at_native_bins_8_to_20_" + window];
            for (std::size_t k = 0; k < bins.size(); ++k)
                CHECK(std::abs(amplitude_at(beat, window, static_cast<double>(k) + 8.0) -
                               bins[k].get<double>()) < allowed);

            const int padding = inp["nfft"].get<int>() / inp["N"].get<int>();
            std::vector<double> peaks_m;
            const auto at = [&](int i) { return amplitude_at(beat, window, 1.0 * i / padding); };
            for (int i = 8 * padding; i < 22 * padding; ++i)
                if (at(i) > 0.35 && at(i) > at(i - 1) && at(i) >= at(i + 1))
                    peaks_m.push_back(i * chirp.bin_m() / padding);
            const Json& expected_m = expect["peak_ranges_m_" + window];
            REQUIRE(peaks_m.size() == expected_m.size());
            for (std::size_t k = 0; k < peaks_m.size(); ++k)
                CHECK(std::abs(peaks_m[k] - expected_m[k].get<double>()) < allowed_m);
        }
    }
}

TEST_CASE("leakage spills into the bins that real sampling and the window leave it",
          "[signal][reference]") {
    const Json reference = reference_case("F11_leakage");
    const Json& inp = reference["points"][0]["inp"];
    const Json& expect = reference["points"][0]["expect"];
    const double near_db = reference["tolerance"]["db_above_minus60"];
    const double far_db = reference["tolerance"]["db_below_minus60"];
    const Chirp chirp = chirp_of(inp["f0"], inp["B"], inp["N"], inp["fs"]);
    const auto mirror = beat_of(chirp, inp["R"]);
    const double level = std::pow(10.0, inp["leak_db"].get<double>() / 20.0);
    const auto both = sum(mirror, beat_of(chirp, inp["Rleak"], level));
    for (const std::string window : {"rect", "hann", "blackman"})
        for (const bool with_leak : {false, true}) {
            const std::string key =
                window + (with_leak ? "_with" : "_without") + "_leak_bins_0_to_20_db";
            const Json& bins = expect[key];
            REQUIRE(bins.size() == 21);
            for (std::size_t k = 0; k < bins.size(); ++k) {
                const double expected_db = bins[k];
                const double found_db = decibel(
                    amplitude_at(with_leak ? both : mirror, window, static_cast<double>(k)));
                INFO(key << " " << k);
                CHECK(std::abs(found_db - expected_db) < (expected_db > -60.0 ? near_db : far_db));
            }
        }
}

TEST_CASE("moving the reflector away turns the beat forward by 4 pi d / wavelength",
          "[signal][reference]") {
    const Json reference = reference_case("F03_phase_displacement");
    const double allowed = reference["tolerance"]["rel"];
    for (const Json& point : reference["points"]) {
        const double frequency_hz = point["inp"]["f_hz"], moved_m = point["inp"]["dz_m"];
        const FrequencyComb comb{frequency_hz, 0.0, 1};
        Channel before = silent_channel(1, comb), after = before;
        add_path(before, comb, {.length_m = 0.9, .transfer = 1.0});
        add_path(after, comb, {.length_m = 0.9 + 2.0 * moved_m, .transfer = 1.0});
        const double turned_rad = std::arg(std::conj(after.h[0]) / std::conj(before.h[0]));
        CHECK(turned_rad == Approx(point["expect"]["dphase_rad"].get<double>()).epsilon(allowed));
    }
}

TEST_CASE("receivers keep their order and their own beat", "[signal]") {
    const Chirp chirp;
    const FrequencyComb comb = comb_of(chirp);
    Channel channel = silent_channel(2, comb);
    add_path(channel, comb, {.rx = 1, .length_m = 0.9, .transfer = 1.0});
    const BeatSignal beat = dechirp(channel, chirp);
    CHECK(beat.n_rx == 2);
    CHECK(beat.of_rx(0)[5] == Complex(0.0));
    CHECK(std::abs(beat.of_rx(1)[5]) == Approx(1.0));
}

TEST_CASE("a channel on another comb than the chirp's is our own mistake", "[signal]") {
    const Chirp chirp;
    CHECK_THROWS_AS(dechirp(silent_channel(1, {60e9, 1e6, 128}), chirp), BrokenPromise);
}

}  // namespace
}  // namespace specula
