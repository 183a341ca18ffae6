/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_RELATIVE_H
#define FW_RELATIVE_H

#include <stddef.h>
#include <stdint.h>

#include "fw_frame.h"
#include "fw_status.h"
#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FW_RELATIVE_MAX_AROUND 31

/* The shape of a spectrum around its strongest echo, in amplitude and phase, as seen from that
 * echo: what is left when distance, gain and phase of the echo are taken out is the sample's own
 * response over the band.
 *
 * search_first, n_search  bins among which the peak is looked for, 3 or more of them
 * n_around    1..FW_RELATIVE_MAX_AROUND: bins of the shape; the peak is number n_around / 2
 * target_bin  > 0: the bin at which the level is not changed by range compensation
 * floor_lsb   > 0: least level */
typedef struct fw_relative_config {
    uint16_t search_first, n_search, n_around;
    fw_window window;
    float target_bin, floor_lsb;
} fw_relative_config;

/* Numbers that fw_relative writes: 2 n_around + 1. */
size_t fw_relative_features(const fw_relative_config* config);

/* Bytes of scratch fw_relative needs for a frame of this shape, whatever the configuration; its
 * samples are not read and may be NULL. 0 if frame is NULL or unsupported. Time: constant. */
size_t fw_relative_scratch(const fw_frame* frame);

/* Whether fw_relative takes such frames under such a configuration; samples are not read and may
 * be NULL. Once FW_OK, all that can still fail is scratch and an echo that is missing.
 *
 * FW_ERR_NULL, FW_ERR_SHAPE, FW_ERR_CONFIG  as fw_relative
 * Time: constant. */
fw_status fw_relative_check(const fw_frame* frame, const fw_relative_config* config);

/* frame -> out: for each bin of the shape the real and the imaginary part of S(peak + k) / S(peak),
 * mean over rows; last the level ln(|S(peak)| peak / target_bin), mean of |S(peak)| over rows.
 *
 * The peak of each row is placed by a parabola; between bins S is the cubic of Catmull and Rom
 * through (-1)^k S[k], which turns slowly (a symmetric window's transform does). Beyond the
 * spectrum S is 0.
 *
 * frame    n_samples a power of two: zero padding would turn the phase from bin to bin
 * scratch  scratch_bytes >= fw_relative_scratch(frame), aligned to 4
 * out      (2 n_around + 1), dimensionless, the last in nepers over 1 LSB; overlaps nothing
 *
 * FW_ERR_NULL       a pointer is NULL
 * FW_ERR_SHAPE      a count of the frame out of range, not a power of two, or no such window
 * FW_ERR_CONFIG     a value of the configuration out of range, or bins beyond the spectrum
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a row without any echo, or one so weak beside other bins that a number would
 *                   be infinite
 * Time: one fw_fft_real per row, 8 multiplications per bin of the shape and row. */
fw_status fw_relative(const fw_frame* frame, const fw_relative_config* config, void* scratch,
                      size_t scratch_bytes, float out[]);

#ifdef __cplusplus
}
#endif

#endif
