/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_mlp.h"

#include <stdbool.h>

#include "fw_finite.h"
#include "fw_float_dot.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

/* Width of the widest array between layers, both ends included; 0 if the shape is unsupported. */
static uint16_t widest(const fw_mlp* mlp) {
    if (mlp->n_layers < 1 || mlp->n_layers > FW_MLP_MAX_LAYERS) return 0;
    uint16_t width = mlp->layer[0].n_in;
    uint16_t n_in = width;
    for (size_t i = 0; i < mlp->n_layers; ++i) {
        const fw_layer* const layer = &mlp->layer[i];
        if (layer->n_in == 0 || layer->n_out == 0 || layer->n_in != n_in) return 0;
        n_in = layer->n_out;
        if (layer->n_out > width) width = layer->n_out;
    }
    return width;
}

static bool has_arrays(const fw_mlp* mlp) {
    for (size_t i = 0; i < mlp->n_layers; ++i) {
        if (mlp->layer[i].weight == NULL || mlp->layer[i].bias == NULL) return false;
    }
    return (mlp->input_mean == NULL) == (mlp->input_scale == NULL);
}

static void normalise(const fw_mlp* mlp, const float features[], float out[]) {
    const float *mean = mlp->input_mean, *scale = mlp->input_scale;
    const float* const end = features + mlp->layer[0].n_in;
    if (mean == NULL) {
        while (features != end) *out++ = *features++;
        return;
    }
    while (features != end) *out++ = (*features++ - *mean++) * *scale++;
}

/* A hidden layer is rectified: max(x, 0), except that NaN stays NaN and so reaches the logits,
 * where it is refused. */
static void run_layer(const fw_layer* layer, bool hidden, const float in[], float out[]) {
    const size_t n_in = layer->n_in, n_out = layer->n_out;
    const float* row = layer->weight;
    size_t o = 0;
    for (; o + 4 <= n_out; o += 4, row += 4 * n_in) {
        fw_dot_four_float(row, in, n_in, layer->bias + o, hidden, out + o);
    }
    for (; o < n_out; ++o) {
        float sum = layer->bias[o];
        for (const float *x = in, *end = in + n_in; x != end; ++x) sum += *row++ * *x;
        out[o] = hidden && sum < 0.0f ? 0.0f : sum;
    }
}

size_t fw_mlp_scratch(const fw_mlp* mlp) {
    return mlp == NULL ? 0 : 2 * sizeof(float) * widest(mlp);
}

fw_status fw_mlp_run(const fw_mlp* mlp, const float features[], void* scratch, size_t scratch_bytes,
                     float logits[], float probabilities[]) {
    if (mlp == NULL || features == NULL || scratch == NULL || logits == NULL) return FW_ERR_NULL;
    const size_t width = widest(mlp);
    if (width == 0) return FW_ERR_SHAPE;
    if (!has_arrays(mlp)) return FW_ERR_NULL;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_mlp_scratch(mlp))) return FW_ERR_SCRATCH;
    if (!fw_all_finite(features, mlp->layer[0].n_in)) return FW_ERR_NONFINITE;

    float* in = scratch;
    float* out = in + width;
    normalise(mlp, features, in);
    for (size_t i = 0; i < mlp->n_layers; ++i) {
        run_layer(&mlp->layer[i], i + 1 < mlp->n_layers, in, out);
        float* const reused = in;
        in = out;
        out = reused;
    }

    const uint16_t n_logits = mlp->layer[mlp->n_layers - 1].n_out;
    if (!fw_all_finite(in, n_logits)) return FW_ERR_NONFINITE;
    for (size_t i = 0; i < n_logits; ++i) logits[i] = in[i];
    return probabilities == NULL ? FW_OK : fw_softmax(logits, n_logits, probabilities);
}
