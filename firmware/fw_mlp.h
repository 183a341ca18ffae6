/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_MLP_H
#define FW_MLP_H

#include <stddef.h>
#include <stdint.h>

#include "fw_softmax.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FW_MLP_MAX_LAYERS 4

/* out[o] = bias[o] + sum over i of weight[o][i] in[i].
 *
 * n_in, n_out  1..65535
 * weight       (n_out, n_in), row-major, finite
 * bias         (n_out), finite */
typedef struct fw_layer {
    uint16_t n_in, n_out;
    const float* weight;
    const float* bias;
} fw_layer;

/* A multilayer perceptron, ReLU between layers, none after the last. Batch normalisation is folded
 * into the weights before they come here. The network borrows its arrays.
 *
 * n_layers     1..FW_MLP_MAX_LAYERS
 * input_mean   (layer[0].n_in), unit of the features
 * input_scale  (layer[0].n_in), one over that unit: x' = (x - mean) * scale. Both NULL for x' = x
 * layer        (n_layers); layer[i].n_in = layer[i - 1].n_out */
typedef struct fw_mlp {
    uint16_t n_layers;
    const float* input_mean;
    const float* input_scale;
    fw_layer layer[FW_MLP_MAX_LAYERS];
} fw_mlp;

/* Bytes of scratch fw_mlp_run needs: two arrays of the widest layer. Weights are not read and may
 * be NULL. 0 if mlp is NULL or its counts are unsupported. Time: n_layers steps. */
size_t fw_mlp_scratch(const fw_mlp* mlp);

/* features -> logits, and probabilities if wanted.
 *
 * Every output is summed in one order: bias first, then inputs by rising index, each product
 * rounded before it is added. So the plain double loop over (o, i) gives the same bits.
 *
 * features       (layer[0].n_in), finite
 * scratch        scratch_bytes >= fw_mlp_scratch(mlp), aligned to 4; contents do not matter
 * logits         out: (n_out of the last layer), dimensionless
 * probabilities  out: the same shape, by fw_softmax; or NULL
 * No two of these arrays overlap.
 *
 * FW_ERR_NULL       a pointer other than probabilities is NULL: an argument, a layer's weight or
 *                   bias, or just one of input_mean and input_scale
 * FW_ERR_SHAPE      n_layers or a layer's counts out of range, or layers that do not fit together
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a feature is infinite or NaN, or a logit would be
 * Time: the sum of n_in * n_out multiplications, and one fw_softmax if wanted. */
fw_status fw_mlp_run(const fw_mlp* mlp, const float features[], void* scratch, size_t scratch_bytes,
                     float logits[], float probabilities[]);

#ifdef __cplusplus
}
#endif

#endif
