/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_FFT_H
#define FW_FFT_H

#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FW_FFT_MAX 1024

/* X[k] = sum over i of x[i] exp(-2 pi j i k / n), in place, unscaled, radix 2.
 *
 * data  (n, 2): real and imaginary part of each value; any unit
 * n     a power of two, 2..FW_FFT_MAX
 *
 * FW_ERR_NULL   data is NULL
 * FW_ERR_SHAPE  n is anything else
 * Time: n/2 log2(n) butterflies. Rounding: |error| <= 6.7 log2(n) 2^-24 |X|, 2-norms over k
 * (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem 24.2). */
fw_status fw_fft_complex(float data[], uint16_t n);

/* The same sum over n real values, through a complex transform of half the size.
 *
 * data  in: (n) real values. Out: (n / 2, 2): bins k = 0..n/2-1, except that data[1], where the
 *       imaginary part of bin 0 would be zero, holds the real bin n/2
 * n     a power of two, 4..FW_FFT_MAX
 *
 * FW_ERR_NULL   data is NULL
 * FW_ERR_SHAPE  n is anything else
 * Time: n/4 log2(n/2) butterflies and n/4 splits. */
fw_status fw_fft_real(float data[], uint16_t n);

#ifdef __cplusplus
}
#endif

#endif
