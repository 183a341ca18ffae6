/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_hwa_fft.h"

#include <stdbool.h>

#include "fw_fft.h"
#include "fw_range_profile.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"
#include "fw_tables.h"

#define WINDOW_BITS 17
#define TWIDDLE_BITS 20
#define DATA_LIMIT 8388607 /* 2^23 - 1 */
#define OUTPUT_LIMIT 32767
#define MAX_OUTPUT_SHIFT 8

_Static_assert((-1 >> 1) == -1, "shifts to the right must keep the sign");

typedef struct twiddle {
    int32_t re, im;
} twiddle;

/* value / 2^bits to the nearest integer, of two equally near the even one. bits >= 1 */
static int64_t divide_to_even(int64_t value, unsigned bits) {
    const int64_t down = value >> bits;
    const int64_t rest = value - down * ((int64_t)1 << bits);
    const int64_t half = (int64_t)1 << (bits - 1);
    const bool up = rest > half || (rest == half && (down & 1) != 0);
    return up ? down + 1 : down;
}

static int32_t saturate(int64_t value, int32_t limit, uint32_t* n_saturated) {
    if (value > limit) {
        ++*n_saturated;
        return limit;
    }
    if (value < -(int64_t)limit - 1) {
        ++*n_saturated;
        return -limit - 1;
    }
    return (int32_t)value;
}

/* A table value, -1..1, as an integer of so many fractional bits. Exact but for the rounding: the
 * product only moves the exponent. */
static int32_t to_fixed(float value, unsigned bits) {
    const float scaled = value * (float)(1 << bits);
    return (int32_t)(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f);
}

/* exp(-2 pi j turn / FW_FFT_MAX), turn = 0..FW_FFT_MAX/2 */
static twiddle twiddle_at(size_t turn) {
    const bool second = turn > FW_SINE_QUARTER;
    const size_t cosine = second ? turn - FW_SINE_QUARTER : FW_SINE_QUARTER - turn;
    const size_t sine = second ? 2 * FW_SINE_QUARTER - turn : turn;
    const int32_t re = to_fixed(fw_sine[cosine], TWIDDLE_BITS);
    return (twiddle){second ? -re : re, -to_fixed(fw_sine[sine], TWIDDLE_BITS)};
}

/* Where bit reversal puts i, of n places. */
static size_t reversed(size_t i, size_t n) {
    size_t result = 0;
    for (size_t bit = 1; bit < n; bit *= 2) {
        result = 2 * result + (i & 1);
        i /= 2;
    }
    return result;
}

/* Windowed samples as complex integers (n, 2), in the order the first stage takes them. */
static void load(const fw_window_shape* window, const int16_t samples[], size_t n, int32_t data[]) {
    const size_t n_samples = window->n_samples;
    for (size_t i = 0; i < n; ++i) {
        int32_t value = 0;
        if (i < n_samples) {
            const size_t mirrored = i < n_samples / 2 ? i : n_samples - 1 - i;
            value = samples[i];
            if (window->half != NULL) {
                const int32_t weight = to_fixed(window->half[mirrored], WINDOW_BITS);
                value = (int32_t)divide_to_even((int64_t)value * weight, WINDOW_BITS);
            }
        }
        int32_t* const place = data + 2 * reversed(i, n);
        place[0] = value;
        place[1] = 0;
    }
}

static int32_t finish(int64_t value, bool halved, uint32_t* n_saturated) {
    return saturate(halved ? divide_to_even(value, 1) : value, DATA_LIMIT, n_saturated);
}

/* (a, b) -> (a + w b, a - w b), halved or saturated */
static void butterfly(int32_t* a, int32_t* b, twiddle w, bool halved, uint32_t* n_saturated) {
    const int64_t re = divide_to_even((int64_t)w.re * b[0] - (int64_t)w.im * b[1], TWIDDLE_BITS);
    const int64_t im = divide_to_even((int64_t)w.re * b[1] + (int64_t)w.im * b[0], TWIDDLE_BITS);
    b[0] = finish(a[0] - re, halved, n_saturated);
    b[1] = finish(a[1] - im, halved, n_saturated);
    a[0] = finish(a[0] + re, halved, n_saturated);
    a[1] = finish(a[1] + im, halved, n_saturated);
}

static void transform(int32_t data[], size_t n, uint32_t scaled_stages, uint32_t* n_saturated) {
    size_t stages_left = 0;
    for (size_t half = n / 2; half > 1; half /= 2) ++stages_left;
    for (size_t half = 1; half < n; half *= 2, --stages_left) {
        const bool halved = (scaled_stages >> stages_left & 1) != 0;
        for (size_t k = 0; k < half; ++k) {
            const twiddle w = twiddle_at(k * (FW_FFT_MAX / 2) / half);
            for (size_t i = k; i < n; i += 2 * half) {
                butterfly(data + 2 * i, data + 2 * (i + half), w, halved, n_saturated);
            }
        }
    }
}

static int16_t output(int32_t value, unsigned shift, uint32_t* n_saturated) {
    const int64_t divided = shift == 0 ? value : divide_to_even(value, shift);
    return (int16_t)saturate(divided, OUTPUT_LIMIT, n_saturated);
}

size_t fw_hwa_fft_scratch(uint16_t n_samples) {
    return 2 * sizeof(int32_t) * fw_range_fft_size(n_samples);
}

fw_status fw_hwa_fft(const int16_t samples[], const fw_hwa_config* config, void* scratch,
                     size_t scratch_bytes, int16_t im_re[], fw_hwa_saturation* saturation) {
    if (samples == NULL || config == NULL || scratch == NULL || im_re == NULL) return FW_ERR_NULL;
    fw_window_shape window;
    const fw_status found = fw_window_find(config->window, config->n_samples, &window);
    if (found != FW_OK) return found;
    const size_t n = fw_range_fft_size(config->n_samples);
    if (config->scaled_stages >= n || config->output_shift > MAX_OUTPUT_SHIFT) {
        return FW_ERR_CONFIG;
    }
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_hwa_fft_scratch(config->n_samples))) {
        return FW_ERR_SCRATCH;
    }

    int32_t* const data = scratch;
    fw_hwa_saturation cut = {0};
    load(&window, samples, n, data);
    transform(data, n, config->scaled_stages, &cut.in_stages);
    /* Results are narrower than data: written from the front, they overtake nothing unread. */
    for (size_t k = 0; k < n / 2; ++k) {
        const int32_t re = data[2 * k], im = data[2 * k + 1];
        im_re[2 * k] = output(im, config->output_shift, &cut.at_output);
        im_re[2 * k + 1] = output(re, config->output_shift, &cut.at_output);
    }
    if (saturation != NULL) *saturation = cut;
    return FW_OK;
}
