/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_EXTRACT_H
#define FW_EXTRACT_H

#include <stddef.h>
#include <stdint.h>

#include "fw_frame.h"
#include "fw_status.h"
#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FW_DEFAULT_FIRST_BIN 6
#define FW_DEFAULT_N_BINS 12

/* Which rows of the frame make the descriptor. */
typedef enum fw_integration {
    FW_INTEGRATE_SINGLE,   /* chirp 0, rx 0 alone */
    FW_INTEGRATE_MEAN,     /* mean of the amplitudes (not of the signals) over chirps and rx */
    FW_INTEGRATE_EXPORTED, /* that mean, rounded as in TLV 302 (fw_exported_profile.h) */
} fw_integration;

/* How a row becomes a spectrum. */
typedef enum fw_range_path {
    FW_RANGE_FLOAT,    /* fw_range_profile: fractions of an LSB are kept */
    FW_RANGE_HWA_LIKE, /* fw_hwa_fft with TI's defaults: whole numbers, as the accelerator gives */
} fw_range_path;

/* The descriptor: amplitudes of range bins first_bin .. first_bin + n_bins - 1.
 * Valid values: fw_range_config in fw_range_profile.h. */
typedef struct fw_extract_config {
    uint16_t first_bin, n_bins;
    fw_window window;
    fw_integration integration;
    fw_range_path path;
} fw_extract_config;

/* Bytes of scratch fw_extract needs for a frame of this shape, whatever the configuration; its
 * samples are not read and may be NULL. 0 if frame is NULL or unsupported. Time: constant. */
size_t fw_extract_scratch(const fw_frame* frame);

/* frame -> descriptor.
 *
 * scratch  scratch_bytes >= fw_extract_scratch(frame), aligned to 4; contents do not matter
 * out      (config->n_bins), LSB, >= 0; overlaps neither samples nor scratch. Rows are added in
 *          storage order: of n rows, rounding adds at most n 2^-24 of the mean
 *
 * FW_ERR_NULL     any pointer, or frame->samples, is NULL
 * FW_ERR_SHAPE    a count of the frame out of range, or the window not tabulated for n_samples
 * FW_ERR_CONFIG   no such window, integration or path, no bins, or bins beyond the spectrum
 * FW_ERR_SCRATCH  scratch too small or misaligned
 * Time: one fw_range_profile or fw_hwa_fft per row used: 1, or n_chirps * n_rx. */
fw_status fw_extract(const fw_frame* frame, const fw_extract_config* config, void* scratch,
                     size_t scratch_bytes, float out[]);

/* fw_extract, which also says how much of the descriptor is wrong because integers were cut off.
 *
 * n_saturated  out: of all rows used, values beyond 24 bits in a stage, and real and imaginary
 *              parts at a limit of int16 in bins of the descriptor (a part that is exactly 32767
 *              counts too). Always 0 with FW_RANGE_FLOAT, which has no limits
 * Errors and time as above; FW_ERR_NULL too if n_saturated is NULL. */
fw_status fw_extract_counted(const fw_frame* frame, const fw_extract_config* config, void* scratch,
                             size_t scratch_bytes, float out[], uint32_t* n_saturated);

#ifdef __cplusplus
}
#endif

#endif
