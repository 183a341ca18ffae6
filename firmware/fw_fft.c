/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_fft.h"

#include <stdbool.h>
#include <stddef.h>

#include "fw_strict_float.h"
#include "fw_tables.h"

_Static_assert(FW_FFT_MAX == 4 * FW_SINE_QUARTER, "the sine table is for the largest transform");

typedef struct twiddle {
    float re, im;
} twiddle;

/* exp(-2 pi j turn / FW_FFT_MAX), turn = 0..FW_FFT_MAX/2: a quarter wave, mirrored. */
static twiddle twiddle_at(size_t turn) {
    if (turn <= FW_SINE_QUARTER) {
        return (twiddle){fw_sine[FW_SINE_QUARTER - turn], -fw_sine[turn]};
    }
    return (twiddle){-fw_sine[turn - FW_SINE_QUARTER], -fw_sine[2 * FW_SINE_QUARTER - turn]};
}

static bool is_size(size_t n, size_t smallest) {
    return n >= smallest && n <= FW_FFT_MAX && (n & (n - 1)) == 0;
}

static void swap(float* a, float* b) {
    const float re = a[0], im = a[1];
    a[0] = b[0];
    a[1] = b[1];
    b[0] = re;
    b[1] = im;
}

static void reverse_bits(float data[], size_t n) {
    size_t reversed = 0;
    for (size_t i = 0; i < n; ++i) {
        if (i < reversed) swap(data + 2 * i, data + 2 * reversed);
        size_t bit = n / 2; /* add one to `reversed`, carrying from the top bit downwards */
        while ((reversed & bit) != 0) {
            reversed ^= bit;
            bit /= 2;
        }
        reversed |= bit;
    }
}

/* (a, b) -> (a + w b, a - w b) */
static void butterfly(float* a, float* b, twiddle w) {
    const float re = w.re * b[0] - w.im * b[1];
    const float im = w.re * b[1] + w.im * b[0];
    b[0] = a[0] - re;
    b[1] = a[1] - im;
    a[0] += re;
    a[1] += im;
}

static void transform(float data[], size_t n) {
    reverse_bits(data, n);
    for (size_t half = 1; half < n; half *= 2) {
        for (size_t k = 0; k < half; ++k) {
            const twiddle w = twiddle_at(k * (FW_FFT_MAX / 2) / half);
            for (size_t i = k; i < n; i += 2 * half) {
                butterfly(data + 2 * i, data + 2 * (i + half), w);
            }
        }
    }
}

/* Bins k and n/2 - k of n real values, from the transform of the pairs (even, odd) at the same two
 * places: a = Z[k], b = Z[n/2 - k]. With E = (a + b*)/2 and O = (a - b*)/2j the spectra of the even
 * and of the odd values, X[k] = E + w O and X[n/2 - k] = (E - w O)*. */
static void split(float* a, float* b, twiddle w) {
    const float even_re = 0.5f * (a[0] + b[0]), even_im = 0.5f * (a[1] - b[1]);
    const float odd_re = 0.5f * (a[1] + b[1]), odd_im = 0.5f * (b[0] - a[0]);
    const float re = w.re * odd_re - w.im * odd_im;
    const float im = w.re * odd_im + w.im * odd_re;
    a[0] = even_re + re;
    a[1] = even_im + im;
    b[0] = even_re - re;
    b[1] = im - even_im;
}

fw_status fw_fft_complex(float data[], uint16_t n) {
    if (data == NULL) return FW_ERR_NULL;
    if (!is_size(n, 2)) return FW_ERR_SHAPE;
    transform(data, n);
    return FW_OK;
}

fw_status fw_fft_real(float data[], uint16_t n) {
    if (data == NULL) return FW_ERR_NULL;
    if (!is_size(n, 4)) return FW_ERR_SHAPE;
    const size_t half = n / 2;
    transform(data, half);

    const float zero = data[0] + data[1], nyquist = data[0] - data[1];
    data[0] = zero;
    data[1] = nyquist;
    for (size_t k = 1; k <= half / 2; ++k) {
        split(data + 2 * k, data + 2 * (half - k), twiddle_at(k * FW_FFT_MAX / n));
    }
    return FW_OK;
}
