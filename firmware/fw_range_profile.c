/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_range_profile.h"

#include <math.h>

#include "fw_fft.h"
#include "fw_frame.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

_Static_assert(FW_MAX_SAMPLES <= FW_FFT_MAX, "every supported row must have a transform");

uint16_t fw_range_fft_size(uint16_t n_samples) {
    if (n_samples < FW_MIN_SAMPLES || n_samples > FW_MAX_SAMPLES) return 0;
    uint16_t size = FW_MIN_SAMPLES;
    while (size < n_samples) size = (uint16_t)(2 * size);
    return size;
}

size_t fw_range_profile_scratch(uint16_t n_samples) {
    return fw_range_fft_size(n_samples) * sizeof(float);
}

/* |bins| of a packed spectrum (n, 2), times scale. */
static void magnitudes(const float bins[], size_t n, float scale, float out[]) {
    for (size_t k = 0; k < n; ++k) {
        const float re = bins[2 * k], im = bins[2 * k + 1];
        out[k] = sqrtf(re * re + im * im) * scale;
    }
}

fw_status fw_range_profile(const int16_t samples[], const fw_range_config* config, void* scratch,
                           size_t scratch_bytes, float amplitude[]) {
    if (samples == NULL || config == NULL || scratch == NULL || amplitude == NULL) {
        return FW_ERR_NULL;
    }
    fw_window_shape window;
    const fw_status found = fw_window_find(config->window, config->n_samples, &window);
    if (found != FW_OK) return found;

    const uint16_t fft_size = fw_range_fft_size(config->n_samples);
    if (config->n_bins == 0 || config->first_bin + config->n_bins > fft_size / 2) {
        return FW_ERR_CONFIG;
    }
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_range_profile_scratch(config->n_samples))) {
        return FW_ERR_SCRATCH;
    }

    float* const spectrum = scratch; /* (fft_size) samples, then (fft_size / 2, 2) bins */
    fw_window_apply(&window, samples, spectrum);
    for (size_t i = config->n_samples; i < fft_size; ++i) spectrum[i] = 0.0f;
    fw_fft_real(spectrum, fft_size);
    spectrum[1] = 0.0f; /* bin 0 is real; fw_fft_real keeps the last bin here */
    magnitudes(spectrum + 2 * config->first_bin, config->n_bins, 2.0f / window.sum, amplitude);
    return FW_OK;
}
