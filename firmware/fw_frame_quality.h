/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_FRAME_QUALITY_H
#define FW_FRAME_QUALITY_H

#include <stdint.h>

#include "fw_frame.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is wrong with a frame before anything is computed from it.
 *
 * n_saturated  samples at a limit of the converter: codes <= -2^(adc_bits - 1) or
 *              >= 2^(adc_bits - 1) - 1
 * n_dead_rows  rows whose samples are all equal: no converter was read
 * peak         largest |code|, LSB */
typedef struct fw_frame_quality {
    uint32_t n_saturated;
    uint32_t n_dead_rows;
    uint16_t peak;
} fw_frame_quality;

/* frame, adc_bits 2..16 -> quality.
 *
 * FW_ERR_NULL    any pointer, or frame->samples, is NULL
 * FW_ERR_SHAPE   a count of the frame out of range
 * FW_ERR_CONFIG  adc_bits out of range
 * Time: n_chirps * n_rx * n_samples comparisons. */
fw_status fw_frame_inspect(const fw_frame* frame, uint16_t adc_bits, fw_frame_quality* quality);

#ifdef __cplusplus
}
#endif

#endif
