/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_extract.h"

#include <math.h>
#include <stdbool.h>

#include "fw_exported_profile.h"
#include "fw_hwa_fft.h"
#include "fw_range_profile.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

#define HWA_DIVISOR (float)(1 << FW_HWA_DEFAULT_OUTPUT_SHIFT)

/* Number of rows to average, from the first on; 0 if there is no such integration. */
static uint32_t rows_used(const fw_frame* frame, fw_integration integration) {
    switch (integration) {
        case FW_INTEGRATE_SINGLE:
            return 1;
        case FW_INTEGRATE_MEAN:
        case FW_INTEGRATE_EXPORTED:
            return (uint32_t)frame->n_chirps * frame->n_rx;
    }
    return 0;
}

/* What the rows share: which bins, through which window, in which memory. */
typedef struct row_plan {
    fw_range_config range;
    fw_window_shape window;
    void* scratch;
    size_t scratch_bytes;
    uint32_t* n_saturated;
} row_plan;

static uint32_t at_limit(int16_t value) {
    return value == INT16_MAX || value == INT16_MIN ? 1 : 0;
}

static fw_status hwa_row(const row_plan* plan, const int16_t samples[], float amplitude[]) {
    const fw_hwa_config config = {.n_samples = plan->range.n_samples,
                                  .window = plan->range.window,
                                  .scaled_stages = FW_HWA_DEFAULT_SCALED_STAGES,
                                  .output_shift = FW_HWA_DEFAULT_OUTPUT_SHIFT};
    int16_t* const im_re = plan->scratch;
    fw_hwa_saturation cut;
    const fw_status status =
        fw_hwa_fft(samples, &config, plan->scratch, plan->scratch_bytes, im_re, &cut);
    if (status != FW_OK) return status;
    *plan->n_saturated += cut.in_stages;
    const float scale = 2.0f * HWA_DIVISOR / plan->window.sum;
    const int16_t* bin = im_re + 2 * plan->range.first_bin;
    for (size_t k = 0; k < plan->range.n_bins; ++k, bin += 2) {
        const float im = bin[0], re = bin[1];
        *plan->n_saturated += at_limit(bin[0]) + at_limit(bin[1]);
        amplitude[k] = sqrtf(re * re + im * im) * scale;
    }
    return FW_OK;
}

static fw_status one_row(const row_plan* plan, fw_range_path path, const int16_t samples[],
                         float amplitude[]) {
    return path == FW_RANGE_HWA_LIKE ? hwa_row(plan, samples, amplitude)
                                     : fw_range_profile(samples, &plan->range, plan->scratch,
                                                        plan->scratch_bytes, amplitude);
}

static void round_as_exported(const fw_window_shape* window, float amplitude[], size_t n) {
    for (size_t k = 0; k < n; ++k) { /* an int16 spectrum is far from any limit of these */
        uint32_t count = 0;
        (void)fw_exported_from_amplitude(window, &amplitude[k], 1, &count);
        (void)fw_exported_to_amplitude(window, &count, 1, &amplitude[k]);
    }
}

/* The shape decides whether a row can be computed: asked before anything is written. */
static fw_status check_plan(const fw_extract_config* config, row_plan* plan) {
    const fw_status found = fw_window_find(config->window, plan->range.n_samples, &plan->window);
    if (found != FW_OK) return found;
    const bool has_path = config->path == FW_RANGE_FLOAT || config->path == FW_RANGE_HWA_LIKE;
    const size_t n_spectrum = fw_range_fft_size(plan->range.n_samples) / 2;
    const bool fits =
        config->n_bins > 0 && (size_t)config->first_bin + config->n_bins <= n_spectrum;
    return has_path && fits ? FW_OK : FW_ERR_CONFIG;
}

/* The scratch of one row, then its amplitudes: at most half a spectrum. The HWA-like transform
 * needs most. */
size_t fw_extract_scratch(const fw_frame* frame) {
    if (frame == NULL || frame->n_chirps == 0 || frame->n_rx == 0) return 0;
    return fw_hwa_fft_scratch(frame->n_samples) +
           fw_range_fft_size(frame->n_samples) / 2 * sizeof(float);
}

fw_status fw_extract(const fw_frame* frame, const fw_extract_config* config, void* scratch,
                     size_t scratch_bytes, float out[]) {
    uint32_t n_saturated;
    return fw_extract_counted(frame, config, scratch, scratch_bytes, out, &n_saturated);
}

fw_status fw_extract_counted(const fw_frame* frame, const fw_extract_config* config, void* scratch,
                             size_t scratch_bytes, float out[], uint32_t* n_saturated) {
    if (frame == NULL || config == NULL || scratch == NULL || out == NULL) return FW_ERR_NULL;
    if (frame->samples == NULL || n_saturated == NULL) return FW_ERR_NULL;
    const size_t needed_bytes = fw_extract_scratch(frame);
    if (needed_bytes == 0) return FW_ERR_SHAPE;
    if (!fw_scratch_fits(scratch, scratch_bytes, needed_bytes)) return FW_ERR_SCRATCH;
    const uint32_t n_rows = rows_used(frame, config->integration);
    if (n_rows == 0) return FW_ERR_CONFIG;

    uint32_t n_cut = 0;
    row_plan plan = {.range = {.n_samples = frame->n_samples,
                               .first_bin = config->first_bin,
                               .n_bins = config->n_bins,
                               .window = config->window},
                     .scratch = scratch,
                     .scratch_bytes = fw_hwa_fft_scratch(frame->n_samples),
                     .n_saturated = &n_cut};
    const fw_status refused = check_plan(config, &plan);
    if (refused != FW_OK) return refused;

    float* const amplitude = (float*)scratch + plan.scratch_bytes / sizeof(float);
    const int16_t* samples = frame->samples;
    for (uint32_t row = 0; row < n_rows; ++row, samples += frame->n_samples) {
        const fw_status status = one_row(&plan, config->path, samples, amplitude);
        if (status != FW_OK) return status; /* cannot come: check_plan asked the same */
        for (size_t k = 0; k < config->n_bins; ++k) {
            out[k] = row == 0 ? amplitude[k] : out[k] + amplitude[k];
        }
    }
    for (size_t k = 0; k < config->n_bins; ++k) out[k] /= (float)n_rows;
    if (config->integration == FW_INTEGRATE_EXPORTED) {
        round_as_exported(&plan.window, out, config->n_bins);
    }
    *n_saturated = n_cut;
    return FW_OK;
}
