/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_NORMALISE_H
#define FW_NORMALISE_H

#include <stdbool.h>
#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What makes a descriptor less dependent on the height of the radar. Applied in this order:
 *
 * align             the profile is shifted so that its strongest peak, interpolated by a parabola
 *                   through three bins, falls on target_bin; between bins it follows the cubic of
 *                   Catmull and Rom, and beyond the profile it is 0
 * compensate_range  times peak / target_bin: a plate's echo falls as 1 / R (its image source), not
 *                   as the 1 / R^2 of a point
 * logarithm         ln(max(amplitude, floor_lsb)), in nepers
 *
 * target_bin, peak  bins counted from bin 0 of the spectrum, so that bin * bin width = range
 * floor_lsb         > 0 and finite; used by logarithm alone */
typedef struct fw_normalise_config {
    bool align;
    bool compensate_range;
    bool logarithm;
    float target_bin;
    float floor_lsb;
} fw_normalise_config;

/* Part of a spectrum: amplitude (n_bins), LSB, of bins first_bin .. first_bin + n_bins - 1. */
typedef struct fw_bins {
    const float* amplitude;
    uint16_t first_bin, n_bins;
} fw_bins;

/* The bin of the strongest peak, counted from bin 0 of the spectrum: between bins by the parabola
 * through the largest amplitude and its neighbours; at either end of the profile, the bin itself.
 * 0 where profile or its amplitudes are NULL or empty. Time: n_bins comparisons. */
float fw_peak_bin(const fw_bins* profile);

/* Whether a configuration can be applied: target_bin finite and > 0 if it is used, so floor_lsb.
 * false for NULL. Time: constant. */
bool fw_normalise_valid(const fw_normalise_config* config);

/* profile -> out (n_out): bins first_out .. first_out + n_out - 1, normalised.
 *
 * profile  finite amplitudes >= 0; holds all bins of out, and more of them where the peak may move
 * out      does not overlap profile
 *
 * FW_ERR_NULL       any pointer is NULL
 * FW_ERR_SHAPE      no bins, or bins of out beyond the profile
 * FW_ERR_CONFIG     not fw_normalise_valid
 * FW_ERR_NONFINITE  an amplitude is infinite or NaN, or a result would be
 * Time: n_bins comparisons, 4 multiplications per bin of out, n_out logarithms. */
fw_status fw_normalise(const fw_bins* profile, const fw_normalise_config* config,
                       uint16_t first_out, uint16_t n_out, float out[]);

#ifdef __cplusplus
}
#endif

#endif
