/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_HWA_FFT_H
#define FW_HWA_FFT_H

#include <stddef.h>
#include <stdint.h>

#include "fw_status.h"
#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The range transform in fixed point, "HWA-like": after what TI documents of the IWRL6432's radar
 * accelerator (HWA 1.2: 24-bit data, a bit per stage that chooses between saturation and halving
 * with convergent rounding) and of its use in the range stage of TI's demo (samples in the low bits
 * of the word, Blackman window in Q17, transform of the next power of two, division by 4 into
 * int16, imaginary part first).
 *
 * Assumed, since TI does not document it: radix 2 with decimation in time, twiddle factors in Q20,
 * every product rounded half to even. So it is not bit-exact with the silicon.
 *
 * n_samples      FW_MIN_SAMPLES..FW_MAX_SAMPLES, and tabulated if the window is not rectangular
 * scaled_stages  bit s: the s-th stage from the last halves its results (convergent rounding);
 *                a stage whose bit is 0 saturates. Bits above log2(fft size) - 1 are refused
 * output_shift   0..8: results are divided by 2^output_shift (convergent), then saturate to int16
 */
typedef struct fw_hwa_config {
    uint16_t n_samples;
    fw_window window;
    uint16_t scaled_stages;
    uint16_t output_shift;
} fw_hwa_config;

/* What TI's demo sets for up to 512 samples: no stage scaled, results divided by 4. A tone of A LSB
 * at the centre of a bin gives A * sum(w) / 8 there, and an offset twice that in bin 0; from 32768
 * on the output saturates. README.md says which amplitudes that are. */
#define FW_HWA_DEFAULT_SCALED_STAGES 0
#define FW_HWA_DEFAULT_OUTPUT_SHIFT 2

/* Values that met a limit and were cut off. One in a stage spoils every bin, one at the output its
 * own bin alone.
 *
 * in_stages  beyond 24 bits, in a stage that was not scaled; impossible with codes of 12 bits
 * at_output  beyond int16: real and imaginary parts of the results */
typedef struct fw_hwa_saturation {
    uint32_t in_stages, at_output;
} fw_hwa_saturation;

/* Bytes of scratch fw_hwa_fft needs: 8 per point of the transform. 0 if n_samples is unsupported.
 * Time: constant. */
size_t fw_hwa_fft_scratch(uint16_t n_samples);

/* One row of samples -> half a spectrum of integers.
 *
 * samples      (config->n_samples), LSB
 * scratch      scratch_bytes >= fw_hwa_fft_scratch(n_samples), aligned to 4
 * im_re        out: (fft size / 2, 2), imaginary part first; sum(w samples exp(..)) / 2^shift, with
 *              one more halving per scaled stage. May be the first bytes of scratch
 * saturation   out: what was cut off, over all bins; or NULL
 *
 * FW_ERR_NULL     a pointer other than saturation is NULL
 * FW_ERR_SHAPE    n_samples out of range, or the window not tabulated for it
 * FW_ERR_CONFIG   no such window, stage or shift
 * FW_ERR_SCRATCH  scratch too small or misaligned
 * Time: fft size / 2 * log2(fft size) butterflies. */
fw_status fw_hwa_fft(const int16_t samples[], const fw_hwa_config* config, void* scratch,
                     size_t scratch_bytes, int16_t im_re[], fw_hwa_saturation* saturation);

#ifdef __cplusplus
}
#endif

#endif
