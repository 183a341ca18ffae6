/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_exported_profile.h"

#include <stddef.h>

#include "fw_strict_float.h"

#define LARGEST 4294967040.0f /* the largest float below 2^32 */

/* Counts per LSB: half the window's sum, divided by 4. */
static float unit(const fw_window_shape* shape) {
    return shape->sum * 0.125f;
}

fw_status fw_exported_from_amplitude(const fw_window_shape* shape, const float amplitude[],
                                     uint16_t n_bins, uint32_t count[]) {
    if (shape == NULL || amplitude == NULL || count == NULL) return FW_ERR_NULL;
    if (n_bins == 0) return FW_ERR_SHAPE;
    for (size_t k = 0; k < n_bins; ++k) { /* written so that NaN is refused too */
        if (!(amplitude[k] >= 0.0f && amplitude[k] * unit(shape) <= LARGEST)) {
            return FW_ERR_NONFINITE;
        }
    }
    for (size_t k = 0; k < n_bins; ++k) {
        const float exact = amplitude[k] * unit(shape);
        const uint32_t down = (uint32_t)exact;
        count[k] = exact - (float)down >= 0.5f ? down + 1 : down;
    }
    return FW_OK;
}

fw_status fw_exported_to_amplitude(const fw_window_shape* shape, const uint32_t count[],
                                   uint16_t n_bins, float amplitude[]) {
    if (shape == NULL || count == NULL || amplitude == NULL) return FW_ERR_NULL;
    if (n_bins == 0) return FW_ERR_SHAPE;
    for (size_t k = 0; k < n_bins; ++k) amplitude[k] = (float)count[k] / unit(shape);
    return FW_OK;
}
