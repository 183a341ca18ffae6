/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_EXPORTED_PROFILE_H
#define FW_EXPORTED_PROFILE_H

#include <stdint.h>

#include "fw_status.h"
#include "fw_window.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A range profile as TI's firmware sends it (UART, TLV 302): whole numbers, one per bin, in the
 * units of the accelerator's int16 output, which is the windowed transform divided by 4. A tone of
 * A LSB at the centre of a bin reads A * sum(w) / 8. */

/* amplitude (n_bins), LSB, as fw_extract gives it -> count (n_bins), rounded to nearest.
 *
 * shape     the window of the profile (fw_window_find)
 * n_bins    1..65535
 *
 * FW_ERR_NULL       any pointer is NULL
 * FW_ERR_SHAPE      n_bins is 0
 * FW_ERR_NONFINITE  an amplitude is negative, not finite, or beyond what 32 bits hold
 * Time: n_bins multiplications. */
fw_status fw_exported_from_amplitude(const fw_window_shape* shape, const float amplitude[],
                                     uint16_t n_bins, uint32_t count[]);

/* count (n_bins) -> amplitude (n_bins), LSB: the descriptor of a profile received as TLV 302.
 * A count above 2^24 loses its last bits to the float.
 *
 * Errors as above, but any count is valid. Time: n_bins multiplications. */
fw_status fw_exported_to_amplitude(const fw_window_shape* shape, const uint32_t count[],
                                   uint16_t n_bins, float amplitude[]);

#ifdef __cplusplus
}
#endif

#endif
