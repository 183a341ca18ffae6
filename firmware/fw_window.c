/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_window.h"

#include <stddef.h>

#include "fw_frame.h"
#include "fw_strict_float.h"
#include "fw_tables.h"

static fw_status find_tabulated(const fw_window_shape table[], uint16_t n_samples,
                                fw_window_shape* shape) {
    for (size_t i = 0; i < FW_N_WINDOW_SIZES; ++i) {
        if (table[i].n_samples == n_samples) {
            *shape = table[i];
            return FW_OK;
        }
    }
    return FW_ERR_SHAPE;
}

fw_status fw_window_find(fw_window window, uint16_t n_samples, fw_window_shape* shape) {
    if (shape == NULL) return FW_ERR_NULL;
    if (n_samples < FW_MIN_SAMPLES || n_samples > FW_MAX_SAMPLES) return FW_ERR_SHAPE;
    switch (window) {
        case FW_WINDOW_RECT:
            *shape = (fw_window_shape){.half = NULL, .sum = n_samples, .n_samples = n_samples};
            return FW_OK;
        case FW_WINDOW_HANN:
            return find_tabulated(fw_hann_windows, n_samples, shape);
        case FW_WINDOW_BLACKMAN:
            return find_tabulated(fw_blackman_windows, n_samples, shape);
    }
    return FW_ERR_CONFIG;
}

fw_status fw_window_apply(const fw_window_shape* shape, const int16_t samples[], float windowed[]) {
    if (shape == NULL || samples == NULL || windowed == NULL) return FW_ERR_NULL;
    const size_t n = shape->n_samples;
    if (shape->half == NULL) {
        for (size_t i = 0; i < n; ++i) windowed[i] = samples[i];
        return FW_OK;
    }
    for (size_t i = 0; i < n / 2; ++i) {
        const size_t mirror = n - 1 - i;
        windowed[i] = shape->half[i] * (float)samples[i];
        windowed[mirror] = shape->half[i] * (float)samples[mirror];
    }
    return FW_OK;
}
