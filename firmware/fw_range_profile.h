/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_RANGE_PROFILE_H
#define FW_RANGE_PROFILE_H

#include <stddef.h>
#include <stdint.h>

#include "fw_status.h"
#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which part of the spectrum, and through which window.
 *
 * n_samples   FW_MIN_SAMPLES..FW_MAX_SAMPLES, and tabulated if the window is not rectangular
 * first_bin   bin k is the frequency k * sample rate / fw_range_fft_size(n_samples)
 * n_bins      1..; first_bin + n_bins <= fw_range_fft_size(n_samples) / 2 */
typedef struct fw_range_config {
    uint16_t n_samples, first_bin, n_bins;
    fw_window window;
} fw_range_config;

/* Transform length for n_samples: the next power of two, samples being zero-padded to it.
 * 0 if n_samples is not FW_MIN_SAMPLES..FW_MAX_SAMPLES. Time: constant. */
uint16_t fw_range_fft_size(uint16_t n_samples);

/* Bytes of scratch fw_range_profile needs; 0 if n_samples is unsupported. Time: constant. */
size_t fw_range_profile_scratch(uint16_t n_samples);

/* One row of samples -> amplitude of some range bins: |FFT(w samples)| * 2 / sum(w).
 * A tone of amplitude A at the centre of a bin reads A there; bin 0 reads twice the offset.
 *
 * samples    (config->n_samples), LSB
 * scratch    scratch_bytes >= fw_range_profile_scratch(config->n_samples), aligned to 4
 * amplitude  out: (config->n_bins), LSB, >= 0; overlaps neither samples nor scratch
 *
 * FW_ERR_NULL     any pointer is NULL
 * FW_ERR_SHAPE    n_samples out of range, or the window not tabulated for it
 * FW_ERR_CONFIG   no such window, no bins, or bins beyond the spectrum
 * FW_ERR_SCRATCH  scratch too small or misaligned
 * Time: one fw_fft_real of fw_range_fft_size(n_samples), and n_bins square roots. */
fw_status fw_range_profile(const int16_t samples[], const fw_range_config* config, void* scratch,
                           size_t scratch_bytes, float amplitude[]);

#ifdef __cplusplus
}
#endif

#endif
