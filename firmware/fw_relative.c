/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_relative.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "fw_fft.h"
#include "fw_finite.h"
#include "fw_log.h"
#include "fw_range_profile.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

typedef struct complex_value {
    float re, im;
} complex_value;

/* A row's spectrum (n_bins, 2), with the alternating sign. */
typedef struct spectrum {
    float* bins;
    int32_t n_bins;
} spectrum;

static bool is_power_of_two(uint32_t n) {
    return n != 0 && (n & (n - 1)) == 0;
}

static bool positive(float value) {
    return value > 0.0f && value <= FLT_MAX;
}

size_t fw_relative_features(const fw_relative_config* config) {
    return config == NULL ? 0 : 2 * (size_t)config->n_around + 1;
}

/* Sums over rows: on the stack they would be the deepest below fw_classify. */
#define SHAPE_BYTES (2 * FW_RELATIVE_MAX_AROUND * sizeof(float))

static size_t spectrum_bytes(const fw_frame* frame) {
    if (frame == NULL || frame->n_chirps == 0 || frame->n_rx == 0) return 0;
    if (!is_power_of_two(frame->n_samples)) return 0;
    return fw_range_profile_scratch(frame->n_samples);
}

size_t fw_relative_scratch(const fw_frame* frame) {
    const size_t n_bytes = spectrum_bytes(frame);
    return n_bytes == 0 ? 0 : n_bytes + SHAPE_BYTES;
}

static complex_value bin_at(const spectrum* s, int32_t index) {
    const complex_value none = {0.0f, 0.0f};
    if (index < 0 || index >= s->n_bins) return none;
    const complex_value value = {s->bins[2 * index], s->bins[2 * index + 1]};
    return value;
}

/* The cubic of Catmull and Rom between b and c. */
static float cubic(float a, float b, float c, float d, float t) {
    const float slope = 0.5f * (c - a);
    const float square = a - 2.5f * b + 2.0f * c - 0.5f * d;
    const float cube = 0.5f * (d - a) + 1.5f * (b - c);
    return b + t * (slope + t * (square + t * cube));
}

static complex_value value_at(const spectrum* s, float place) {
    const complex_value none = {0.0f, 0.0f};
    if (place <= -2.0f || place >= (float)s->n_bins + 1.0f) return none;
    const int32_t index = (int32_t)(place + 2.0f) - 2; /* towards minus infinity */
    const float t = place - (float)index;
    const complex_value a = bin_at(s, index - 1), b = bin_at(s, index);
    const complex_value c = bin_at(s, index + 1), d = bin_at(s, index + 2);
    const complex_value value = {cubic(a.re, b.re, c.re, d.re, t),
                                 cubic(a.im, b.im, c.im, d.im, t)};
    return value;
}

static float magnitude(complex_value value) {
    return sqrtf(value.re * value.re + value.im * value.im);
}

/* Place of the strongest bin of the search, between bins by a parabola. */
static float peak_place(const spectrum* s, const fw_relative_config* config) {
    int32_t top = config->search_first;
    float largest = -1.0f;
    for (int32_t k = config->search_first; k < config->search_first + config->n_search; ++k) {
        const float value = magnitude(bin_at(s, k));
        if (value > largest) {
            largest = value;
            top = k;
        }
    }
    const float left = magnitude(bin_at(s, top - 1)), right = magnitude(bin_at(s, top + 1));
    const float bend = left - 2.0f * largest + right; /* <= 0 at a maximum */
    const float offset = bend < 0.0f ? 0.5f * (left - right) / bend : 0.0f;
    return (float)top + (offset > 0.5f ? 0.5f : offset < -0.5f ? -0.5f : offset);
}

static void transform(const fw_window_shape* window, const int16_t samples[], spectrum* s) {
    (void)fw_window_apply(window, samples, s->bins);
    (void)fw_fft_real(s->bins, window->n_samples);
    s->bins[1] = 0.0f; /* bin 0 is real; fw_fft_real keeps the last bin here */
    for (int32_t k = 1; k < s->n_bins; k += 2) {
        s->bins[2 * k] = -s->bins[2 * k];
        s->bins[2 * k + 1] = -s->bins[2 * k + 1];
    }
}

/* Adds a row's shape to out and its level, range compensated, to *level. */
static bool add_row(const spectrum* s, const fw_relative_config* config, float out[],
                    float* level) {
    const float peak = peak_place(s, config);
    const complex_value top = value_at(s, peak);
    const float square = top.re * top.re + top.im * top.im;
    if (!positive(square)) return false;
    const float first = peak - (float)(config->n_around / 2);
    for (size_t k = 0; k < config->n_around; ++k) {
        const complex_value value = value_at(s, first + (float)k);
        out[2 * k] += (value.re * top.re + value.im * top.im) / square;
        out[2 * k + 1] += (value.im * top.re - value.re * top.im) / square;
    }
    *level += sqrtf(square) * peak / config->target_bin;
    return true;
}

static bool valid(const fw_relative_config* config, int32_t n_bins) {
    return config->n_around >= 1 && config->n_around <= FW_RELATIVE_MAX_AROUND &&
           config->n_search >= 3 && config->search_first + config->n_search <= n_bins &&
           positive(config->target_bin) && positive(config->floor_lsb);
}

fw_status fw_relative_check(const fw_frame* frame, const fw_relative_config* config) {
    if (frame == NULL || config == NULL) return FW_ERR_NULL;
    if (spectrum_bytes(frame) == 0) return FW_ERR_SHAPE;
    fw_window_shape window;
    const fw_status found = fw_window_find(config->window, frame->n_samples, &window);
    if (found != FW_OK) return found;
    return valid(config, frame->n_samples / 2) ? FW_OK : FW_ERR_CONFIG;
}

fw_status fw_relative(const fw_frame* frame, const fw_relative_config* config, void* scratch,
                      size_t scratch_bytes, float out[]) {
    if (frame == NULL || config == NULL || scratch == NULL || out == NULL) return FW_ERR_NULL;
    if (frame->samples == NULL) return FW_ERR_NULL;
    const fw_status refused = fw_relative_check(frame, config);
    if (refused != FW_OK) return refused;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_relative_scratch(frame))) {
        return FW_ERR_SCRATCH;
    }
    fw_window_shape window;
    (void)fw_window_find(config->window, frame->n_samples, &window);
    spectrum s = {.bins = scratch, .n_bins = frame->n_samples / 2};

    const size_t n_shape = 2 * (size_t)config->n_around;
    const uint32_t n_rows = (uint32_t)frame->n_chirps * frame->n_rx;
    /* out stays untouched on an error */
    float* const shape = (float*)scratch + spectrum_bytes(frame) / sizeof(float);
    for (size_t k = 0; k < n_shape; ++k) shape[k] = 0.0f;
    float level = 0.0f;
    for (uint32_t row = 0; row < n_rows; ++row) {
        transform(&window, frame->samples + (size_t)row * frame->n_samples, &s);
        if (!add_row(&s, config, shape, &level)) return FW_ERR_NONFINITE;
    }
    if (!fw_all_finite(shape, (uint16_t)n_shape) || !fw_all_finite(&level, 1)) {
        return FW_ERR_NONFINITE;
    }
    for (size_t k = 0; k < n_shape; ++k) out[k] = shape[k] / (float)n_rows;
    level *= 2.0f / window.sum / (float)n_rows;
    out[n_shape] = fw_log(level > config->floor_lsb ? level : config->floor_lsb);
    return FW_OK;
}
