/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_WINDOW_H
#define FW_WINDOW_H

#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Symmetric windows over i = 0..N-1, with x = 2 pi i / (N - 1). */
typedef enum fw_window {
    FW_WINDOW_RECT,     /* 1                                     any N */
    FW_WINDOW_HANN,     /* 0.5 - 0.5 cos x                       N = 64, 128, 256, 512 */
    FW_WINDOW_BLACKMAN, /* 0.42 - 0.5 cos x + 0.08 cos 2x        N = 64, 128, 256, 512 */
} fw_window;

/* A window of one length. It is symmetric, so the first half says all.
 *
 * half  (n_samples / 2), dimensionless, 0..1; NULL stands for all ones
 * sum   of all n_samples values: the gain of the window for a constant */
typedef struct fw_window_shape {
    const float* half;
    float sum;
    uint16_t n_samples;
} fw_window_shape;

/* The window of n_samples values (FW_MIN_SAMPLES..FW_MAX_SAMPLES), written to shape.
 * Nothing is computed: a length without a table is refused.
 *
 * FW_ERR_NULL    shape is NULL
 * FW_ERR_SHAPE   n_samples out of range, or window not tabulated for it
 * FW_ERR_CONFIG  no such window
 * Time: constant. */
fw_status fw_window_find(fw_window window, uint16_t n_samples, fw_window_shape* shape);

/* samples (n_samples), LSB -> windowed (n_samples), LSB: each sample times its window value.
 *
 * FW_ERR_NULL  any pointer is NULL
 * Time: n_samples multiplications. */
fw_status fw_window_apply(const fw_window_shape* shape, const int16_t samples[], float windowed[]);

#ifdef __cplusplus
}
#endif

#endif
