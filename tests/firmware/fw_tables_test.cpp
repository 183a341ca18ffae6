#include "firmware/fw_tables.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

std::uint32_t bits(double value) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

/// The windows without cancellation, from s = sin^2(pi i / (N - 1)).
double window_by_squares(fw_window kind, std::size_t i, std::size_t n) {
    const double sine =
        std::sin(std::numbers::pi * static_cast<double>(i) / static_cast<double>(n - 1));
    const double s = sine * sine;
    return kind == FW_WINDOW_HANN ? s : s * (0.36 + 0.64 * s);
}

const fw_window_shape* table_of(fw_window kind) {
    return kind == FW_WINDOW_HANN ? fw_hann_windows : fw_blackman_windows;
}

}  // namespace

TEST_CASE("every twiddle entry is the sine rounded once", "[firmware]") {
    for (int k = 0; k <= FW_SINE_QUARTER; ++k) {
        CAPTURE(k);
        CHECK(bits(fw_sine[k]) == bits(std::sin(std::numbers::pi / 2 * k / FW_SINE_QUARTER)));
    }
    CHECK(fw_sine[0] == 0.0F);
    CHECK(fw_sine[FW_SINE_QUARTER] == 1.0F);
}

TEST_CASE("the tabulated lengths are 64, 128, 256 and 512", "[firmware]") {
    for (const fw_window kind : {FW_WINDOW_HANN, FW_WINDOW_BLACKMAN}) {
        for (int i = 0; i < FW_N_WINDOW_SIZES; ++i) {
            CHECK(table_of(kind)[i].n_samples == 64 << i);
        }
    }
}

TEST_CASE("every window entry is the window rounded once", "[firmware]") {
    const auto kind = GENERATE(FW_WINDOW_HANN, FW_WINDOW_BLACKMAN);
    const auto size = GENERATE(0, 1, 2, 3);
    const auto& table = table_of(kind)[size];
    for (std::size_t i = 0; i < table.n_samples / 2U; ++i) {
        CAPTURE(kind, table.n_samples, i);
        CHECK(bits(table.half[i]) == bits(window_by_squares(kind, i, table.n_samples)));
        // Half a gap of floats just below 1, which is what rounding to float may cost.
        CHECK(std::abs(table.half[i] - oracle::window(kind, i, table.n_samples)) <= 0x1p-25);
    }
    CHECK(table.half[0] == 0.0F);
}

TEST_CASE("a window sums to its constant term times N - 1", "[firmware]") {
    // Over i = 0..N-1 each cosine passes whole periods and repeats its first value, 1, at the end:
    // sum = a0 N - a1 + a2, and for both windows a0 - a1 + a2 = 0.
    for (int i = 0; i < FW_N_WINDOW_SIZES; ++i) {
        const int n = 64 << i;
        CHECK(bits(fw_hann_windows[i].sum) == bits(0.5 * (n - 1)));
        CHECK(bits(fw_blackman_windows[i].sum) == bits(0.42 * (n - 1)));
    }
}
