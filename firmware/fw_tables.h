/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_TABLES_H
#define FW_TABLES_H

/* Constants of the FFT and of the windows. fw_tables.c is written by generate_tables.py and
 * committed: computed at run time, they would depend on the libm of the machine. */

#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FW_SINE_QUARTER 256
#define FW_N_WINDOW_SIZES 4

/* (k): sin(2 pi k / 1024) over the first quarter turn, both ends included. */
extern const float fw_sine[FW_SINE_QUARTER + 1];

/* (size): lengths 64, 128, 256, 512. */
extern const fw_window_shape fw_hann_windows[FW_N_WINDOW_SIZES];
extern const fw_window_shape fw_blackman_windows[FW_N_WINDOW_SIZES];

#ifdef __cplusplus
}
#endif

#endif
