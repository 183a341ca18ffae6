#include "classifier/peak_shape.hpp"

#include <cmath>
#include <numbers>

#include "classifier/relative_profile.hpp"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

constexpr int n_shape_samples = 128, n_shape_rx = 2;

/// One frame per place: an echo there and a weak one two bins behind it, on both receivers.
Dataset echoes_at(const std::vector<double>& bins, int samples = n_shape_samples) {
    Dataset dataset;
    dataset.class_names = {"a", "b"};
    dataset.n_chirps = 1;
    dataset.n_rx = n_shape_rx;
    dataset.n_samples = samples;
    for (const double bin : bins) {
        for (int rx = 0; rx < n_shape_rx; ++rx)
            for (int i = 0; i < samples; ++i) {
                const double turn = 2.0 * std::numbers::pi * i / samples;
                dataset.adc.push_back(static_cast<std::int16_t>(
                    std::lround(900.0 * std::cos(turn * bin + 0.4 * rx) +
                                120.0 * std::cos(turn * (bin + 2.0) + 0.4 * rx + 1.0))));
            }
        dataset.truth.emplace_back();
    }
    return dataset;
}

const std::string line = " 6 12 blackman align 12 range 12 search 4 20";

TEST_CASE("the chip's shape of an echo does not depend on where the echo is", "[descriptor]") {
    const FeatureTable rows =
        describe(echoes_at({9.0, 10.0, 14.0}), parse_descriptor("peak_shape" + line), 1);
    REQUIRE(rows.n_features == 25);
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t k = 0; k + 1 < rows.n_features; ++k) {
            INFO(i << " " << k);
            // Whole bins apart: only rounding to codes and the image of the negative frequencies
            // differ, which this window holds below a thousandth.
            CHECK(rows.row(i)[k] == Approx(rows.row(0)[k]).margin(3e-3));
        }
    // The level falls as 1 / R is compensated: times 14 / 9, equal amplitudes.
    CHECK(static_cast<double>(rows.row(2)[24] - rows.row(0)[24]) ==
          Approx(std::log(14.0 / 9.0)).margin(5e-3));
}

TEST_CASE("the chip's shape has the amplitudes of the exact one", "[descriptor]") {
    const Dataset dataset = echoes_at({11.3, 12.0});
    const FeatureTable chip = describe(dataset, parse_descriptor("peak_shape" + line), 1);
    const FeatureTable exact = describe(dataset, parse_descriptor("relative_profile" + line), 1);
    for (std::size_t i = 0; i < chip.size(); ++i)
        for (std::size_t k = 0; k < 12; ++k) {
            const auto size = [&](const FeatureTable& rows) {
                return std::hypot(rows.row(i)[2 * k], rows.row(i)[2 * k + 1]);
            };
            INFO(i << " " << k);
            CHECK(size(chip) ==
                  Approx(size(exact)).margin(0.06));  // 0.044, worked out apart from the code
        }
}

TEST_CASE("the shape is the same for any number of threads", "[descriptor]") {
    const Dataset dataset = echoes_at({9.1, 10.2, 11.3, 12.4, 13.5});
    const Descriptor descriptor = parse_descriptor("peak_shape" + line);
    CHECK(describe(dataset, descriptor, 1).features == describe(dataset, descriptor, 3).features);
}

TEST_CASE("frames that are no power of two have no shape", "[descriptor]") {
    const Dataset dataset = echoes_at({12.0}, 96);
    const std::string message = message_of([&] {
        describe(dataset, parse_descriptor("peak_shape 6 12 rect align 12 range 12 search 4 20"),
                 1);
    });
    CHECK(message.find("peak_shape cannot be taken from frames of 96 samples") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
