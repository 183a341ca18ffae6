/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_frame_quality.h"

#include <stdbool.h>
#include <stddef.h>

#define MIN_ADC_BITS 2
#define MAX_ADC_BITS 16

static bool has_shape(const fw_frame* frame) {
    return frame->n_chirps > 0 && frame->n_rx > 0 && frame->n_samples >= FW_MIN_SAMPLES &&
           frame->n_samples <= FW_MAX_SAMPLES;
}

static void inspect_row(const int16_t samples[], size_t n, int32_t limit, fw_frame_quality* sum) {
    bool dead = true;
    for (size_t i = 0; i < n; ++i) {
        const int32_t code = samples[i];
        const int32_t size = code < 0 ? -code : code;
        if (code <= -limit || code >= limit - 1) ++sum->n_saturated;
        if (size > sum->peak) sum->peak = (uint16_t)size;
        if (samples[i] != samples[0]) dead = false;
    }
    if (dead) ++sum->n_dead_rows;
}

fw_status fw_frame_inspect(const fw_frame* frame, uint16_t adc_bits, fw_frame_quality* quality) {
    if (frame == NULL || quality == NULL || frame->samples == NULL) return FW_ERR_NULL;
    if (!has_shape(frame)) return FW_ERR_SHAPE;
    if (adc_bits < MIN_ADC_BITS || adc_bits > MAX_ADC_BITS) return FW_ERR_CONFIG;

    fw_frame_quality sum = {0};
    const int32_t limit = (int32_t)1 << (adc_bits - 1);
    const size_t n_rows = (size_t)frame->n_chirps * frame->n_rx;
    for (size_t row = 0; row < n_rows; ++row) {
        inspect_row(frame->samples + row * frame->n_samples, frame->n_samples, limit, &sum);
    }
    *quality = sum;
    return FW_OK;
}
