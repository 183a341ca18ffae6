#include "classifier/augment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "firmware/fw_extract.h"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/kind.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/project_library.hpp"

namespace specula {
namespace {

constexpr int n_samples = 128;
constexpr double bin_m = 0.039;
const StreamKey augmentation_key{.seed = 7, .purpose = "test", .world = 1, .item = 3};

Augmentation recipe(const std::vector<std::string>& steps) {
    Augmentation how;
    for (const std::string& step : steps) how.steps.push_back(step_of(step));
    how.radar.bin_m = bin_m;
    how.radar.n_samples = n_samples;
    return how;
}

FrameSamples tone(double amplitude, double bin, double phase_rad, int n_rx = 1) {
    FrameSamples frame;
    frame.n_rx = n_rx;
    frame.n_samples = n_samples;
    for (int i = 0; i < n_rx * n_samples; ++i)
        frame.in_phase.push_back(amplitude *
                                 std::cos(phase_rad + two_pi * bin * (i % n_samples) / n_samples));
    return frame;
}

/// The firmware's descriptor of samples rounded to codes, all bins, mean over RX.
std::vector<float> descriptor(const FrameSamples& frame, std::uint16_t n_bins = 64) {
    std::vector<std::int16_t> codes;
    for (const double sample : frame.in_phase)
        codes.push_back(static_cast<std::int16_t>(std::lround(sample)));
    const fw_frame view{.samples = codes.data(),
                        .n_chirps = 1,
                        .n_rx = static_cast<std::uint16_t>(frame.n_rx),
                        .n_samples = static_cast<std::uint16_t>(frame.n_samples)};
    const fw_extract_config config{.first_bin = 0,
                                   .n_bins = n_bins,
                                   .window = FW_WINDOW_BLACKMAN,
                                   .integration = FW_INTEGRATE_MEAN,
                                   .path = FW_RANGE_FLOAT};
    std::vector<float> out(n_bins), scratch(fw_extract_scratch(&view) / sizeof(float) + 1);
    REQUIRE(fw_extract(&view, &config, scratch.data(), scratch.size() * sizeof(float),
                       out.data()) == FW_OK);
    return out;
}

double largest_gap(const std::vector<float>& a, const std::vector<float>& b, std::size_t first,
                   std::size_t last) {
    double gap = 0.0;
    for (std::size_t k = first; k < last; ++k)
        gap = std::max(gap, std::abs(static_cast<double>(a[k]) - b[k]));
    return gap;
}

TEST_CASE("6 dB of gain are a factor of 1.995 in codes and in descriptors", "[augment]") {
    FrameSamples frame = tone(100.0, 11.5, 0.3);
    const FrameSamples before = frame;
    CHECK(augment_codes(frame, recipe({"gain=6"}), 0.45, augmentation_key) ==
          std::vector<double>{6.0});
    const double factor = std::pow(10.0, 0.3);
    for (std::size_t i = 0; i < frame.in_phase.size(); ++i)
        CHECK(frame.in_phase[i] == Approx(factor * before.in_phase[i]).epsilon(1e-12));
    std::vector<float> row{1.0f, 0.0f, 250.0f};
    augment_row(row, recipe({"gain=6"}), 0.45, augmentation_key);
    CHECK(row[2] == Approx(250.0 * factor).epsilon(1e-6));  // a float's resolution
    CHECK(row[1] == 0.0f);
}

TEST_CASE("noise has the deviation asked for and no mean", "[augment]") {
    FrameSamples frame = tone(0.0, 0.0, 0.0, 200);
    augment_codes(frame, recipe({"noise=5"}), 0.45, augmentation_key);
    double sum = 0.0, square = 0.0;
    for (const double sample : frame.in_phase) {
        sum += sample;
        square += sample * sample;
    }
    const double n = static_cast<double>(frame.in_phase.size());  // 25600: 1/sqrt(n) = 0.6 %
    CHECK(std::abs(sum / n) < 4.0 * 5.0 / std::sqrt(n));
    CHECK(std::sqrt(square / n) == Approx(5.0).epsilon(4.0 / std::sqrt(2.0 * n)));
}

TEST_CASE("noise on a descriptor is that of noise in its codes", "[augment]") {
    // Without an echo the mean of |n| over many frames is sigma_bin sqrt(pi / 2), by either way.
    Augmentation how = recipe({"noise=20"});
    double of_codes = 0.0, of_rows = 0.0;
    constexpr int n_frames = 60, first = 8, last = 60;
    for (std::uint32_t i = 0; i < n_frames; ++i) {
        StreamKey own = augmentation_key;
        own.item = i;
        FrameSamples frame = tone(0.0, 0.0, 0.0);
        augment_codes(frame, how, 0.45, own);
        const std::vector<float> direct = descriptor(frame);
        std::vector<float> row(64, 0.0f);
        augment_row(row, how, 0.45, own);
        of_codes += std::accumulate(direct.begin() + first, direct.begin() + last, 0.0);
        of_rows += std::accumulate(row.begin() + first, row.begin() + last, 0.0);
    }
    // Some 3000 bins, of which a window makes 1000 independent: 0.52 / sqrt(1000) is 1.7 %.
    CHECK(of_rows == Approx(of_codes).epsilon(4.0 * 0.017 * std::sqrt(2.0)));
}

TEST_CASE("a tone of clutter falls with the square of its range and stands at its bin",
          "[augment]") {
    Section section =
        Section::parse("kind = \"clutter\"\nlevel_lsb = 400\nrange_mm = 1170\n", "clutter");
    Augmentation how = recipe({});
    how.steps.push_back(read_kind<AugmentStep>(section, "kind"));
    FrameSamples frame = tone(0.0, 0.0, 0.0, 3);
    augment_codes(frame, how, 0.45, augmentation_key);
    const std::vector<float> profile = descriptor(frame);
    CHECK(profile[30] == Approx(400.0 / (1.17 * 1.17)).epsilon(2e-3));  // rounding to codes
    CHECK(std::max_element(profile.begin(), profile.end()) - profile.begin() == 30);

    std::vector<float> row(64, 0.0f);
    augment_row(row, how, 0.45, augmentation_key);
    // Of 292; the firmware's window is symmetric, the line that of a periodic one: 1 / N apart.
    CHECK(largest_gap(row, profile, 4, 60) < 292.0 / n_samples);
}

TEST_CASE("an echo moved by the ramp stands where its new range says", "[augment]") {
    for (const double bins : {-3.0, -1.28, 0.5, 2.56, 7.7}) {
        FrameSamples frame = tone(1000.0, 11.53, 1.1);
        augment_codes(frame, recipe({format("shift={}", bins * bin_m * 1e3)}), 11.53 * bin_m,
                      augmentation_key);
        const std::vector<float> moved = descriptor(frame);
        const std::vector<float> direct = descriptor(tone(1000.0, 11.53 + bins, 0.2));
        INFO(bins << " bins, off by " << largest_gap(moved, direct, 5, 40) << " of 1000");
        CHECK(largest_gap(moved, direct, 5, 40) < 10.0);
    }
}

TEST_CASE("leakage stays where it is when the scene moves", "[augment]") {
    FrameSamples frame = tone(0.0, 0.0, 0.0);
    const FrameSamples leakage = tone(500.0, 1.0, 0.7), echo = tone(200.0, 12.0, 0.1);
    for (std::size_t i = 0; i < frame.in_phase.size(); ++i)
        frame.in_phase[i] = leakage.in_phase[i] + echo.in_phase[i];
    const double before = descriptor(frame)[1];
    augment_codes(frame, recipe({"shift=156"}), 12 * bin_m, augmentation_key);  // four bins
    const std::vector<float> moved = descriptor(frame);
    CHECK(moved[1] == Approx(before).epsilon(0.01));
    CHECK(moved[16] == Approx(200.0).epsilon(0.02));
    CHECK(moved[12] < 4.0);
}

TEST_CASE("complex samples move without error, and a way back is the way", "[augment]") {
    FrameSamples frame;
    frame.n_samples = n_samples;
    for (int i = 0; i < n_samples; ++i) {
        const double angle_rad = two_pi * 12.0 * i / n_samples;  // one bin: no end effects
        frame.in_phase.push_back(300.0 * std::cos(angle_rad));
        frame.quadrature.push_back(300.0 * std::sin(angle_rad));
    }
    Augmentation how = recipe({"shift=50", "shift=-50"});
    how.radar.start_hz = 58e9;  // so that the carrier turns back too
    const FrameSamples before = frame;
    augment_codes(frame, how, 12 * bin_m, augmentation_key);
    for (std::size_t i = 0; i < n_samples; ++i) {
        // The slow part takes a little of an echo between two bins, most of it at the ends.
        CHECK(frame.in_phase[i] == Approx(before.in_phase[i]).margin(8.0));
        CHECK(frame.quadrature[i] == Approx(before.quadrature[i]).margin(8.0));
    }
}

Scene plate_at(double height_m) {
    Scene scene;
    scene.radar = read_radar(SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml");
    scene.sample.material = "aluminium";
    scene.sample.face = {.size_x_m = 0.7, .size_y_m = 0.7};  // a mirror: no rim to be seen
    scene.pose.height_m = height_m;
    return scene;
}

FrameSamples simulated(double height_m) {
    Stream noise({.seed = 1, .purpose = "thermal noise"});
    const AdcFrame frame = simulate(plate_at(height_m), library(), noise);
    FrameSamples samples;
    samples.n_rx = frame.n_rx;
    samples.n_samples = frame.n_samples;
    samples.in_phase.assign(frame.codes.begin(), frame.codes.end());
    return samples;
}

struct Moved {
    double height_m, most;  ///< and how much of the peak a bin may be off
};

TEST_CASE("a chirp moved to another height agrees with one simulated there", "[augment][sim]") {
    const FrameSamples start = simulated(0.45);
    const std::vector<float> before = descriptor(start, 24);
    // Farther away, bin 6 is reached by the 2 % of leakage (465 LSB) that cannot be told from
    // echoes.
    for (const auto& [height_m, most] :
         {Moved{0.38, 0.01}, {0.43, 0.01}, {0.47, 0.01}, {0.52, 0.04}}) {
        Augmentation how = recipe({format("range={}", (height_m - 0.45) * 1e3)});
        how.radar = view_of(plate_at(0.45).radar);
        FrameSamples moved = start;
        augment_codes(moved, how, 0.45, augmentation_key);
        const std::vector<float> got = descriptor(moved, 24);
        const std::vector<float> wanted = descriptor(simulated(height_m), 24);
        const double peak = *std::max_element(wanted.begin() + 6, wanted.begin() + 18);
        INFO(height_m << " m: off by " << largest_gap(got, wanted, 6, 18) << " of " << peak);
        CHECK(largest_gap(got, wanted, 6, 18) < most * peak);
        CHECK(largest_gap(before, wanted, 6, 18) > 0.1 * peak);  // it is no small matter
    }
}

TEST_CASE("a descriptor moved to another height agrees with that of a chirp simulated there",
          "[augment][sim]") {
    const std::vector<float> start = descriptor(simulated(0.45), 24);
    for (const double height_m : {0.38, 0.43, 0.47, 0.52}) {
        Augmentation how = recipe({format("range={}", (height_m - 0.45) * 1e3)});
        how.radar = view_of(plate_at(0.45).radar);
        std::vector<float> moved = start;
        augment_row(moved, how, 0.45, augmentation_key);
        const std::vector<float> wanted = descriptor(simulated(height_m), 24);
        const double peak = *std::max_element(wanted.begin() + 6, wanted.begin() + 18);
        INFO(height_m << " m: off by " << largest_gap(moved, wanted, 6, 18) << " of " << peak);
        CHECK(largest_gap(moved, wanted, 6, 18) < 0.03 * peak);  // between bins: 2.4 % of a line
    }
}

TEST_CASE("the same key gives the same copy, and each copy, frame, step and epoch another",
          "[augment]") {
    const Augmentation how = recipe({"gain=-3:3", "gain=-3:3"});
    const auto drawn = [&](const StreamKey& of) {
        FrameSamples frame = tone(100.0, 11.0, 0.0);
        return augment_codes(frame, how, 0.45, of);
    };
    const auto first = drawn(augmentation_key);
    CHECK(drawn(augmentation_key) == first);
    CHECK(first[0] != first[1]);
    StreamKey other = augmentation_key;
    other.world = 2;
    CHECK(drawn(other) != first);
    other = augmentation_key;
    other.item = 4;
    CHECK(drawn(other) != first);
    other = augmentation_key;
    other.seed = 8;
    CHECK(drawn(other) != first);
    for (const double gain_db : first) CHECK(std::abs(gain_db) <= 3.0);
}

TEST_CASE("rows are changed one by one, whatever rows stand beside them", "[augment]") {
    FeatureTable rows;
    rows.n_features = 4;
    rows.features = {10, 20, 30, 5, 10, 20, 30, 5};
    rows.label = {0, 1};
    rows.world = rows.session = {0, 0};
    rows.class_names = {"a", "b"};
    const Augmentation how = recipe({"gain=-2:2", "noise=3"});
    const FeatureTable changed = augmented(rows, how, augmentation_key);
    CHECK(changed.label == rows.label);
    CHECK(changed.row(0)[1] != changed.row(1)[1]);
    StreamKey second = augmentation_key;
    ++second.item;
    const FeatureTable alone =
        augmented(select_rows(rows, std::vector<std::size_t>{1}), how, second);
    CHECK(std::equal(alone.features.begin(), alone.features.end(), changed.row(1).begin()));
}

TEST_CASE("steps that cannot be taken are refused by name", "[augment]") {
    for (const auto& [text, problem] : {std::pair{"echo=3", "--step echo=3: is no step"},
                                        {"gain", "--step gain: is no step"},
                                        {"gain=loud", "\"loud\" is no number"},
                                        {"noise=-1", "level_lsb = -1"},
                                        {"noise=3:0", "--step noise=3:0: level_lsb.uniform"},
                                        {"gain=500", "at least -60 dB and at most 60 dB"},
                                        {"noise=0:nan", "nan"},
                                        {"gain=1:", "\"\" is no number"}})
        CHECK(message_of([&, text = text] { return step_of(text); }).find(problem) !=
              std::string::npos);
    FrameSamples frame = tone(100.0, 11.0, 0.0);
    CHECK(message_of([&] {
              return augment_codes(frame, recipe({"range=-400"}), 0.45, augmentation_key);
          }).find("to within 3 range bins of the radar") != std::string::npos);
    Augmentation blind = recipe({"shift=10"});
    blind.radar.bin_m = 0.0;
    CHECK(message_of([&] {
              return augment_codes(frame, blind, 0.45, augmentation_key);
          }).find("--radar") != std::string::npos);
}

}  // namespace
}  // namespace specula
