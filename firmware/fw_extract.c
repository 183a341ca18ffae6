/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_extract.h"

#include "fw_range_profile.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

/* Number of rows to average, from the first on; 0 if there is no such integration. */
static uint32_t rows_used(const fw_frame* frame, fw_integration integration) {
    switch (integration) {
        case FW_INTEGRATE_SINGLE:
            return 1;
        case FW_INTEGRATE_MEAN:
            return (uint32_t)frame->n_chirps * frame->n_rx;
    }
    return 0;
}

/* The scratch of one range profile, then the amplitudes of one row: at most half a spectrum. */
size_t fw_extract_scratch(const fw_frame* frame) {
    if (frame == NULL || frame->n_chirps == 0 || frame->n_rx == 0) return 0;
    return fw_range_profile_scratch(frame->n_samples) +
           fw_range_fft_size(frame->n_samples) / 2 * sizeof(float);
}

fw_status fw_extract(const fw_frame* frame, const fw_extract_config* config, void* scratch,
                     size_t scratch_bytes, float out[]) {
    if (frame == NULL || config == NULL || scratch == NULL || out == NULL) return FW_ERR_NULL;
    if (frame->samples == NULL) return FW_ERR_NULL;
    const size_t needed_bytes = fw_extract_scratch(frame);
    if (needed_bytes == 0) return FW_ERR_SHAPE;
    if (!fw_scratch_fits(scratch, scratch_bytes, needed_bytes)) return FW_ERR_SCRATCH;
    const uint32_t n_rows = rows_used(frame, config->integration);
    if (n_rows == 0) return FW_ERR_CONFIG;

    const fw_range_config range = {.n_samples = frame->n_samples,
                                   .first_bin = config->first_bin,
                                   .n_bins = config->n_bins,
                                   .window = config->window};
    const size_t profile_bytes = fw_range_profile_scratch(frame->n_samples);
    float* const amplitude = (float*)scratch + profile_bytes / sizeof(float);
    const int16_t* samples = frame->samples;
    for (uint32_t row = 0; row < n_rows; ++row, samples += frame->n_samples) {
        /* Refusals depend on the shape alone: they come at row 0, before anything is written. */
        const fw_status status =
            fw_range_profile(samples, &range, scratch, profile_bytes, amplitude);
        if (status != FW_OK) return status;
        for (size_t k = 0; k < range.n_bins; ++k) {
            out[k] = row == 0 ? amplitude[k] : out[k] + amplitude[k];
        }
    }
    for (size_t k = 0; k < range.n_bins; ++k) out[k] /= (float)n_rows;
    return FW_OK;
}
