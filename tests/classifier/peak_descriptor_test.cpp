#include <cmath>
#include <complex>

#include "classifier/descriptor.hpp"
#include "classifier/extract_features.hpp"
#include "classifier/looks.hpp"
#include "classifier/relative_profile.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

/// An echo: a tone per receiver, and a weaker one that follows it.
struct Echo {
    double bin = 12.0;
    double amplitude = 4000.0;
    double phase_rad = 0.3;
    double step_rad = 0.0;       ///< from one receiver to the next
    double follower = 0.0;       ///< amplitude of the second tone over that of the first
    double follower_bins = 2.0;  ///< behind the first
    double follower_rad = 1.1;
};

constexpr int n_echo_samples = 128, n_echo_rx = 3, n_echo_chirps = 2;

/// One frame per echo, sessions of four frames.
Dataset frames_of(const std::vector<Echo>& echoes) {
    Dataset dataset;
    dataset.class_names = {"a"};
    dataset.n_chirps = n_echo_chirps;
    dataset.n_rx = n_echo_rx;
    dataset.n_samples = n_echo_samples;
    for (const Echo& echo : echoes) {
        dataset.truth.push_back({.session = static_cast<int>(dataset.truth.size()) / 4});
        for (int chirp = 0; chirp < n_echo_chirps; ++chirp)
            for (int rx = 0; rx < n_echo_rx; ++rx)
                for (int i = 0; i < n_echo_samples; ++i) {
                    const double at = two_pi * i / n_echo_samples;
                    const double phase = echo.phase_rad + echo.step_rad * rx;
                    const double first = std::cos(at * echo.bin + phase);
                    const double second =
                        std::cos(at * (echo.bin + echo.follower_bins) + phase + echo.follower_rad);
                    dataset.adc.push_back(static_cast<std::int16_t>(
                        std::lround(echo.amplitude * (first + echo.follower * second))));
                }
    }
    return dataset;
}

double largest_difference(std::span<const float> a, std::span<const float> b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
    return largest;
}

const std::string aligned = "range_bins 6 12 blackman align 12 search 5 20";

TEST_CASE("a descriptor's line is read back as it was written", "[descriptor]") {
    for (const std::string line :
         {"range_bins 6 12 blackman", "columns 0 3 rect", "range_windows 0 12 blackman",
          "range_bins 6 12 hann single", "range_bins 6 12 hann exported hwa",
          "range_bins 6 12 blackman align 12 range 12 log 0.5 search 5 20",
          "range_bins 6 12 blackman unit", "range_bins 6 12 blackman align 12.25 search 5 20 unit",
          "range_bins 6 12 blackman search 5 20 angle 3",
          "relative_profile 6 12 blackman align 12 range 12 search 5 20 angle 3 looks 8 spread"})
        CHECK(parse_descriptor(line).text() == line);
    CHECK(parse_descriptor("relative_profile 6 12 blackman align 12 range 12").n_features() == 25);
    CHECK(parse_descriptor("range_bins 6 12 hann angle 3 looks 8 spread").n_features() == 32);
}

TEST_CASE("a line that makes no descriptor is refused, saying which word is wrong",
          "[descriptor]") {
    const auto problem = [](const std::string& line) {
        const std::string message = message_of([&] { return parse_descriptor(line).n_features(); });
        const std::string start = "descriptor = \"" + line + "\": ";
        REQUIRE(message.rfind(start, 0) == 0);
        return message.substr(start.size(), message.find(';') - start.size());
    };
    CHECK(problem("bins 6 12 hann").rfind("begins with none of", 0) == 0);
    CHECK(problem("range_bins 6") == "the count of bins needs a number from 1 to 65535");
    CHECK(problem("range_bins 6 12 kaiser") == "the window is rect, hann or blackman");
    CHECK(problem("range_bins 6 12 hann align") == "align needs a number from 0.001 to 65535");
    CHECK(problem("range_bins 6 12 hann align 12 range 13") ==
          "align and range name different bins");
    CHECK(problem("range_bins 6 12 hann search 7 20 align 12") ==
          "search does not hold all of the bins");
    CHECK(problem("range_bins 6 12 hann unit log 1") == "unit and log exclude each other");
    CHECK(problem("relative_profile 6 12 hann") == "a relative_profile needs align and range");
    CHECK(problem("columns 0 3 rect log 1") == "log and unit go with range_bins");
    CHECK(problem("range_bins 6 12 hann spread") == "spread needs looks");
    CHECK(problem("range_bins 6 12 hann shiny").rfind("\"shiny\" is none of align", 0) == 0);
}

TEST_CASE("steps that are off leave the firmware's bins bit for bit", "[descriptor]") {
    const Dataset dataset = frames_of({{}, {.bin = 13.4}});
    const auto plain = describe(dataset, parse_descriptor("range_bins 6 12 blackman"), 1);
    const auto angled =
        describe(dataset, parse_descriptor("range_bins 6 12 blackman search 5 20 angle 3"), 1);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 12; ++k) CHECK(angled.row(i)[k] == plain.row(i)[k]);
}

TEST_CASE("an echo that moved by bins keeps its aligned bins; fixed ones lose it", "[descriptor]") {
    const Dataset dataset = frames_of({{.bin = 12.0}, {.bin = 9.0}, {.bin = 15.0}, {.bin = 14.0}});
    const auto rows = describe(dataset, parse_descriptor(aligned), 1);
    const auto fixed = describe(dataset, parse_descriptor("range_bins 6 12 blackman"), 1);
    for (std::size_t i = 1; i < 4; ++i) {
        // The main lobe of a Blackman window is six bins wide and its side lobes are 58 dB down,
        // 0.0012 of 4000; codes are whole numbers.
        CHECK(largest_difference(rows.row(i), rows.row(0)) < 10.0);
        CHECK(largest_difference(fixed.row(i), fixed.row(0)) > 2000.0);
    }
}

TEST_CASE("range compensation brings an echo that falls as 1 / R to one level", "[descriptor]") {
    const Dataset dataset =
        frames_of({{.bin = 12.0}, {.bin = 15.0, .amplitude = 4000.0 * 12.0 / 15.0}});
    const auto rows = describe(dataset, parse_descriptor(aligned + " range 12"), 1);
    CHECK(rows.row(1)[6] == Approx(rows.row(0)[6]).epsilon(1e-3));
    const auto in_log = describe(dataset, parse_descriptor(aligned + " range 12 log 1"), 1);
    CHECK(double(in_log.row(0)[6]) == Approx(std::log(double(rows.row(0)[6]))).epsilon(1e-6));
}

TEST_CASE("unit energy takes the level away and nothing else", "[descriptor]") {
    const Dataset dataset =
        frames_of({{.amplitude = 8000.0, .follower = 0.2}, {.amplitude = 500.0, .follower = 0.2}});
    const auto rows = describe(dataset, parse_descriptor("range_bins 6 12 blackman unit"), 1);
    double energy = 0.0;
    for (const float value : rows.row(0)) energy += double(value) * double(value);
    CHECK(energy == Approx(1.0).epsilon(1e-6));
    CHECK(largest_difference(rows.row(0), rows.row(1)) < 2e-3);  // half a code of 500
}

/// The 25 numbers by plain sums of a complex exponential at every place.
std::vector<double> plain_relative(const Dataset& dataset, double peak) {
    std::vector<std::complex<double>> mean(12);
    double level = 0.0;
    const auto at = [&](int rx, double bin) {
        std::complex<double> sum = 0.0;
        double weights = 0.0;
        for (int i = 0; i < n_echo_samples; ++i) {
            const double x = two_pi * i / (n_echo_samples - 1);
            const double window = 0.42 - 0.5 * std::cos(x) + 0.08 * std::cos(2.0 * x);
            weights += window;
            double code = 0.0;
            for (int chirp = 0; chirp < n_echo_chirps; ++chirp)
                code += dataset.adc[std::size_t((chirp * n_echo_rx + rx) * n_echo_samples + i)] /
                        double(n_echo_chirps);
            sum += window * code * std::polar(1.0, -two_pi * bin * i / n_echo_samples);
        }
        return sum * 2.0 / weights;
    };
    for (int rx = 0; rx < n_echo_rx; ++rx) {
        level += std::abs(at(rx, peak)) / n_echo_rx;
        for (int k = 0; k < 12; ++k)
            mean[std::size_t(k)] += at(rx, peak + k + 6 - 12) / at(rx, peak) / double(n_echo_rx);
    }
    std::vector<double> features;
    for (const auto& value : mean) {
        features.push_back(value.real());
        features.push_back(value.imag());
    }
    features.push_back(std::log(level * peak / 12.0));
    return features;
}

const std::string relative = "relative_profile 6 12 blackman align 12 range 12 search 5 20";

TEST_CASE("the relative profile is its definition, summed plainly", "[descriptor]") {
    const Echo echo{.bin = 13.0, .step_rad = 0.4, .follower = 0.3};
    const Dataset dataset = frames_of({echo});
    const auto rows = describe(dataset, parse_descriptor(relative), 1);
    REQUIRE(rows.n_features == 25);
    // Where the peak is, the firmware says; it is near the stronger tone.
    fw_extract_config bins = parse_descriptor(relative).bins;
    bins.first_bin = 5;
    bins.n_bins = 20;
    const FeatureTable profile = extract_features(dataset, bins, 1);
    const fw_bins seen{profile.row(0).data(), 5, 20};
    const double peak = double(fw_peak_bin(&seen));
    CHECK(peak == Approx(13.0).margin(0.5));
    const auto expected = plain_relative(dataset, peak);
    for (std::size_t k = 0; k < 25; ++k)  // tables and results are float
        CHECK(double(rows.row(0)[k]) == Approx(expected[k]).margin(2e-6).epsilon(1e-5));
    CHECK(rows.row(0)[12] == Approx(1.0f));  // the peak itself
    CHECK(rows.row(0)[13] == Approx(0.0f).margin(1e-6));
}

TEST_CASE("range, phase, level and angle do not show in the relative profile", "[descriptor]") {
    const auto with = [](double bin, double amplitude, double phase, double step) {
        return Echo{.bin = bin,
                    .amplitude = amplitude,
                    .phase_rad = phase,
                    .step_rad = step,
                    .follower = 0.25};
    };
    const Dataset dataset = frames_of({with(12.0, 6000, 0.3, 0.0), with(14.0, 6000, 1.9, 0.0),
                                       with(10.0, 3000, -2.0, 0.7), with(12.3, 6000, 0.3, 0.0)});
    const auto rows = describe(dataset, parse_descriptor(relative), 1);
    for (std::size_t i = 1; i < 3; ++i)  // moved by whole bins: rounding of codes, side lobes
        CHECK(largest_difference(rows.row(i).first(24), rows.row(0).first(24)) < 4e-3);
    // Between bins the parabola misses the top by up to 0.03 bins, which turns and tilts the rest.
    CHECK(largest_difference(rows.row(3).first(24), rows.row(0).first(24)) < 0.12);
    // Another follower is another shape.
    const Dataset other = frames_of({{.follower = 0.25, .follower_rad = 2.6}});
    CHECK(largest_difference(describe(other, parse_descriptor(relative), 1).row(0), rows.row(0)) >
          0.2);
    // The level: ln(6000) + ln(bin / 12), and the follower's share in it the same.
    CHECK(double(rows.row(1)[24] - rows.row(0)[24]) == Approx(std::log(14.0 / 12.0)).margin(2e-3));
    CHECK(double(rows.row(2)[24] - rows.row(0)[24]) ==
          Approx(std::log(0.5 * 10.0 / 12.0)).margin(2e-3));
}

TEST_CASE("the angle cue is the phase from receiver to receiver", "[descriptor]") {
    const double step = GENERATE(-2.0, 0.0, 0.9, 3.0);
    const Dataset dataset = frames_of({{.bin = 12.4, .step_rad = step}});
    const auto rows =
        describe(dataset, parse_descriptor("range_bins 6 12 blackman search 5 20 angle 3"), 1);
    REQUIRE(rows.n_features == 16);
    for (int rx = 1; rx < 3; ++rx) {
        const auto at = static_cast<std::size_t>(12 + 2 * (rx - 1));
        CHECK(double(rows.row(0)[at]) == Approx(std::cos(step * rx)).margin(1e-3));
        CHECK(double(rows.row(0)[at + 1]) == Approx(std::sin(step * rx)).margin(1e-3));
    }
    CHECK(message_of([&] {
              return describe(dataset, parse_descriptor("range_bins 6 12 blackman angle 2"), 1)
                  .size();
          }) == "descriptor: angle 2: the frames have 3 receivers; use angle 3, or none for one");
}

TEST_CASE("looks are means and spreads over frames of one session", "[descriptor]") {
    std::vector<Echo> echoes;
    for (int i = 0; i < 11; ++i) echoes.push_back({.amplitude = 1000.0 + 100.0 * i});
    const Dataset dataset = frames_of(echoes);  // sessions of 4, 4 and 3
    const auto single = describe(dataset, parse_descriptor("range_bins 6 12 blackman"), 1);
    const auto rows =
        describe(dataset, parse_descriptor("range_bins 6 12 blackman looks 2 spread"), 1);
    REQUIRE(rows.n_features == 24);
    REQUIRE(rows.size() == 5);  // 2, 2 and 1
    CHECK(rows.session == std::vector<std::int32_t>{0, 0, 1, 1, 2});
    for (std::size_t k = 0; k < 12; ++k) {
        const double a = double(single.row(4)[k]), b = double(single.row(5)[k]);
        CHECK(double(rows.row(2)[k]) == Approx((a + b) / 2.0).epsilon(1e-6));
        CHECK(double(rows.row(2)[12 + k]) == Approx(std::abs(a - b) / 2.0).margin(1e-4));
    }
    CHECK(first_rows(single, {.count = 2}) == std::vector<std::size_t>{0, 2, 4, 6, 8});
    CHECK(message_of([&] {
              return describe(dataset, parse_descriptor("range_bins 6 12 blackman looks 5"), 1)
                  .size();
          }) == "descriptor: looks 5: no session has that many frames; use fewer");
}

TEST_CASE("every descriptor is the same for any number of threads", "[descriptor]") {
    std::vector<Echo> echoes;
    for (int i = 0; i < 300; ++i) echoes.push_back({.bin = 9.0 + 0.02 * i, .follower = 0.2});
    const Dataset dataset = frames_of(echoes);
    for (const std::string& line :
         {aligned + " range 12 log 1", relative + " angle 3", relative + " looks 4 spread"})
        CHECK(describe(dataset, parse_descriptor(line), 1).features ==
              describe(dataset, parse_descriptor(line), 3).features);
}

}  // namespace
}  // namespace specula
