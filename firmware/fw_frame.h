/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_FRAME_H
#define FW_FRAME_H

#include <stdint.h>

#define FW_MIN_SAMPLES 16
#define FW_MAX_SAMPLES 1024

/* One frame of a real-only ADC, borrowed: the owner keeps the samples alive and unchanged.
 *
 * samples    (chirp, rx, sample), row-major without gaps, ADC codes in LSB, any int16
 * n_chirps   1..65535
 * n_rx       1..65535: receive antennas, or virtual ones after TDM separation
 * n_samples  FW_MIN_SAMPLES..FW_MAX_SAMPLES; need not be a power of two */
typedef struct fw_frame {
    const int16_t* samples;
    uint16_t n_chirps, n_rx, n_samples;
} fw_frame;

#endif
