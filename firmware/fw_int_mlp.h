/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_INT_MLP_H
#define FW_INT_MLP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fw_mlp.h"
#include "fw_softmax.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fw_int_width {
    FW_INT8,  /* weights in int8, values between layers in -127..127 */
    FW_INT16, /* weights in int16, values between layers in -32767..32767 */
} fw_int_width;

/* sum[o] = bias[o] + sum over i of weight[o][i] in[i], in 32 bits. A hidden layer then gives
 * clamp(round(sum[o] * multiplier[o] / 2^shift[o]), 0, largest), halves upwards, which is the ReLU
 * too; the last layer gives the logit scale[o] * sum[o].
 *
 * n_in, n_out  1..65535
 * weight       (n_out, stride) of int8_t or int16_t, aligned to 4. stride is n_in rounded up to 4
 *              (int8) or 2 (int16); what is beyond n_in is 0. For every o,
 *              largest * sum over i of |weight[o][i]| + |bias[o]| <= 2^31 - 1
 * bias         (n_out)
 * multiplier   (n_out), 0..2^31 - 1; hidden layers only
 * shift        (n_out), 33..62; hidden layers only
 * scale        (n_out), |.| < 1e28; last layer only */
typedef struct fw_int_layer {
    uint16_t n_in, n_out;
    const void* weight;
    const int32_t* bias;
    const int32_t* multiplier;
    const int32_t* shift;
    const float* scale;
} fw_int_layer;

/* fw_mlp in integers: the inputs are brought to x' = (x - mean) * scale as there, then to
 * clamp(round(x' * input_levels), -largest, largest), halves away from 0.
 *
 * n_layers      1..FW_MLP_MAX_LAYERS
 * input_mean, input_scale  (layer[0].n_in)
 * input_levels  steps of the integer per unit of x', finite, > 0. So x' ends at largest /
 *               input_levels: 6 standard deviations of the training rows in what the exporter
 *               writes. Beyond, a float network goes on and this one stands still, and their
 *               labels may differ: fw_int_clipped tells
 * layer         (n_layers); layer[i].n_in = layer[i - 1].n_out */
typedef struct fw_int_mlp {
    fw_int_width width;
    uint16_t n_layers;
    const float* input_mean;
    const float* input_scale;
    float input_levels;
    fw_int_layer layer[FW_MLP_MAX_LAYERS];
} fw_int_mlp;

/* Length of one row of weights of n_in inputs, with its padding. Time: constant. */
uint32_t fw_int_stride(fw_int_width width, uint16_t n_in);

/* Bytes of scratch fw_int_mlp_run needs: two arrays of int16 of the widest layer. 0 if mlp is NULL
 * or its counts are unsupported. Time: n_layers steps. */
size_t fw_int_mlp_scratch(const fw_int_mlp* mlp);

/* How many of features (layer[0].n_in) lie beyond what the integers reach, and so count as the
 * nearest value within: their network's answer is not the float network's. NaN counts too. 0 if a
 * pointer is NULL. Time: layer[0].n_in multiplications. */
uint16_t fw_int_clipped(const fw_int_mlp* mlp, const float features[]);

/* Whether no sum of a layer can leave 32 bits, and its shifts, multipliers and scales are in range;
 * is_last says which of them the layer has. Checked once, when a model is opened.
 *
 * FW_ERR_NULL   an array is missing
 * FW_ERR_SHAPE  a count is 0
 * FW_ERR_VALUE  a number out of range, padding that is not 0, or a sum that could overflow
 * Time: n_out * n_in steps. */
fw_status fw_int_layer_check(const fw_int_layer* layer, fw_int_width width, bool is_last);

/* features -> logits, and probabilities if wanted. Integer sums are exact, so their order does not
 * matter: any implementation of the formulas above gives the same bits.
 *
 * features       (layer[0].n_in), finite
 * scratch        scratch_bytes >= fw_int_mlp_scratch(mlp), aligned to 4; contents do not matter
 * logits         out: (n_out of the last layer), dimensionless
 * probabilities  out: the same shape, by fw_softmax; or NULL
 * The layers have passed fw_int_layer_check.
 *
 * FW_ERR_NULL       a pointer other than probabilities is NULL, an array of a layer too
 * FW_ERR_SHAPE      n_layers or a layer's counts out of range, or layers that do not fit together
 * FW_ERR_CONFIG     no such width
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a feature is infinite or NaN
 * Time: the sum of n_in * n_out multiplications, and one fw_softmax if wanted. */
fw_status fw_int_mlp_run(const fw_int_mlp* mlp, const float features[], void* scratch,
                         size_t scratch_bytes, float logits[], float probabilities[]);

#ifdef __cplusplus
}
#endif

#endif
