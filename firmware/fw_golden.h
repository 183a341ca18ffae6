/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_GOLDEN_H
#define FW_GOLDEN_H

/* Inputs and results of the self-test. fw_golden.c is written by generate_golden.py, which states
 * the arithmetic again in Python, rounding after every operation as a float unit does, and checks
 * itself against double precision. Floats are stored as their bits. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FW_GOLDEN_N_SAMPLES 128
#define FW_GOLDEN_N_IN 12
#define FW_GOLDEN_N_AROUND 12
#define FW_GOLDEN_N_SHAPE (2 * FW_GOLDEN_N_AROUND + 1)
#define FW_GOLDEN_N_HIDDEN 6
#define FW_GOLDEN_N_OUT 5
#define FW_GOLDEN_N_SUBNORMAL 2
#define FW_GOLDEN_SHIFT 40
#define FW_GOLDEN_INPUT_LEVELS 16.0f

/* (sample): two tones and noise, LSB. */
extern const int16_t fw_golden_chirp[FW_GOLDEN_N_SAMPLES];

/* Bins 6..17 through a Blackman window: amplitudes, and (bin, 2) of fw_hwa_fft. */
extern const uint32_t fw_golden_profile[FW_GOLDEN_N_IN];
extern const int16_t fw_golden_im_re[2 * FW_GOLDEN_N_IN];

/* The shape of the strongest peak of bins 4..23, level at bin 11.5. */
extern const uint32_t fw_golden_shape[FW_GOLDEN_N_SHAPE];

/* A network 12-6-5 on (amplitude - 4) / 16: whole weights, (out, in), and biases, of the first
 * layer and then of the second; in float each counts 1/512. Its integer forms use the weights as
 * they are, the same multiplier in every hidden row, and logits of 2^-10 per unit of the sum. */
#define FW_GOLDEN_N_WEIGHT_0 (FW_GOLDEN_N_HIDDEN * FW_GOLDEN_N_IN)
#define FW_GOLDEN_N_WEIGHTS (FW_GOLDEN_N_WEIGHT_0 + FW_GOLDEN_N_OUT * FW_GOLDEN_N_HIDDEN)
extern const int8_t fw_golden_weight[FW_GOLDEN_N_WEIGHTS];
extern const int32_t fw_golden_bias[FW_GOLDEN_N_HIDDEN + FW_GOLDEN_N_OUT];
extern const int32_t fw_golden_multiplier[FW_GOLDEN_N_HIDDEN];

extern const uint32_t fw_golden_logits[FW_GOLDEN_N_OUT];
extern const uint32_t fw_golden_logits_int16[FW_GOLDEN_N_OUT];
extern const uint32_t fw_golden_logits_int8[FW_GOLDEN_N_OUT];
extern const uint32_t fw_golden_probabilities[FW_GOLDEN_N_OUT];

/* A layer (out, in) without bias: its first sum is subnormal and made of normal numbers, its second
 * is normal and has a subnormal weight in it. */
extern const uint32_t fw_golden_subnormal_in[FW_GOLDEN_N_SUBNORMAL];
extern const uint32_t fw_golden_subnormal_weight[FW_GOLDEN_N_SUBNORMAL * FW_GOLDEN_N_SUBNORMAL];
extern const uint32_t fw_golden_subnormal_logits[FW_GOLDEN_N_SUBNORMAL];

#ifdef __cplusplus
}
#endif

#endif
