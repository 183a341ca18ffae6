/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_int_mlp.h"

#include "fw_finite.h"
#include "fw_int_dot.h"
#include "fw_scratch.h"
#include "fw_strict_float.h"

static int32_t largest_of(fw_int_width width) {
    return width == FW_INT8 ? 127 : 32767;
}

uint32_t fw_int_stride(fw_int_width width, uint16_t n_in) {
    const uint32_t multiple = width == FW_INT8 ? 4 : 2;
    return (n_in + multiple - 1) / multiple * multiple;
}

/* Width of the widest array between layers, both ends included; 0 if the shape is unsupported. */
static uint16_t widest(const fw_int_mlp* mlp) {
    if (mlp->n_layers < 1 || mlp->n_layers > FW_MLP_MAX_LAYERS) return 0;
    uint16_t width = mlp->layer[0].n_in;
    uint16_t n_in = width;
    for (size_t i = 0; i < mlp->n_layers; ++i) {
        const fw_int_layer* const layer = &mlp->layer[i];
        if (layer->n_in == 0 || layer->n_out == 0 || layer->n_in != n_in) return 0;
        n_in = layer->n_out;
        if (layer->n_out > width) width = layer->n_out;
    }
    return width;
}

/* Values per array of scratch: a whole number of words of four bytes of weights. */
static size_t padded(uint16_t width) {
    return ((size_t)width + 3) / 4 * 4;
}

size_t fw_int_mlp_scratch(const fw_int_mlp* mlp) {
    return mlp == NULL ? 0 : 2 * sizeof(int16_t) * padded(widest(mlp));
}

static bool has_arrays(const fw_int_layer* layer, bool is_last) {
    if (layer->weight == NULL || layer->bias == NULL) return false;
    return is_last ? layer->scale != NULL : layer->multiplier != NULL && layer->shift != NULL;
}

static bool all_there(const fw_int_mlp* mlp) {
    if (mlp->input_mean == NULL || mlp->input_scale == NULL) return false;
    for (size_t i = 0; i < mlp->n_layers; ++i) {
        if (!has_arrays(&mlp->layer[i], i + 1 == mlp->n_layers)) return false;
    }
    return true;
}

/* An input in steps, not rounded. */
static inline float level_of(const fw_int_mlp* mlp, const float features[], size_t i) {
    return (features[i] - mlp->input_mean[i]) * mlp->input_scale[i] * mlp->input_levels;
}

/* The inputs as integers. */
static void quantise(const fw_int_mlp* mlp, const float features[], int16_t out[]) {
    const float largest = (float)largest_of(mlp->width);
    for (size_t i = 0; i < mlp->layer[0].n_in; ++i) {
        float level = level_of(mlp, features, i);
        level += level < 0.0f ? -0.5f : 0.5f;
        /* Both comparisons are false for NaN (0 * infinity), which then counts as 0. */
        if (level > largest) level = largest;
        if (level < -largest) level = -largest;
        out[i] = level == level ? (int16_t)level : 0;
    }
}

uint16_t fw_int_clipped(const fw_int_mlp* mlp, const float features[]) {
    if (mlp == NULL || features == NULL) return 0;
    const float beyond = (float)largest_of(mlp->width) + 0.5f; /* rounds to more than largest */
    uint16_t n = 0;
    for (size_t i = 0; i < mlp->layer[0].n_in; ++i) {
        const float level = level_of(mlp, features, i);
        if (!(level < beyond && level > -beyond)) ++n;
    }
    return n;
}

/* clamp(round(sum * multiplier / 2^shift), 0, largest). From 33 on, half of 2^shift is a multiple
 * of 2^32, so the lower half of the product decides nothing and 32 bits suffice. */
static inline int16_t requantise(int32_t sum, int32_t multiplier, int32_t shift, int32_t largest) {
    if (sum <= 0) return 0;
    const int32_t high = (int32_t)((int64_t)sum * multiplier >> 32);
    const int32_t level = (high + ((int32_t)1 << (shift - 33))) >> (shift - 32);
    return (int16_t)(level > largest ? largest : level);
}

/* sum (4): up to four sums of a layer, from row o on; returns how many. */
static size_t some_sums(const fw_int_layer* layer, fw_int_width width, size_t o, const int16_t in[],
                        int32_t sum[4]) {
    const size_t n = fw_int_stride(width, layer->n_in);
    const size_t n_rows = layer->n_out - o < 4 ? 1 : 4;
    for (size_t r = 0; r < n_rows; ++r) sum[r] = layer->bias[o + r];
    if (width == FW_INT8) {
        const int8_t* const row = (const int8_t*)layer->weight + o * n;
        if (n_rows == 4) {
            fw_dot_four_int8(row, in, n, sum);
        } else {
            sum[0] = fw_dot_one_int8(row, in, n, sum[0]);
        }
    } else {
        const int16_t* const row = (const int16_t*)layer->weight + o * n;
        if (n_rows == 4) {
            fw_dot_four_int16(row, in, n, sum);
        } else {
            sum[0] = fw_dot_one_int16(row, in, n, sum[0]);
        }
    }
    return n_rows;
}

static void hidden_layer(const fw_int_layer* layer, fw_int_width width, const int16_t in[],
                         int16_t out[]) {
    const int32_t largest = largest_of(width);
    int32_t sum[4];
    for (size_t o = 0; o < layer->n_out;) {
        const size_t n = some_sums(layer, width, o, in, sum);
        for (size_t r = 0; r < n; ++r, ++o) {
            out[o] = requantise(sum[r], layer->multiplier[o], layer->shift[o], largest);
        }
    }
}

static void last_layer(const fw_int_layer* layer, fw_int_width width, const int16_t in[],
                       float logits[]) {
    int32_t sum[4];
    for (size_t o = 0; o < layer->n_out;) {
        const size_t n = some_sums(layer, width, o, in, sum);
        for (size_t r = 0; r < n; ++r, ++o) logits[o] = layer->scale[o] * (float)sum[r];
    }
}

/* Zeroes what the weights' padding meets, and puts the values in the kernel's order. */
static void prepare(int16_t values[], size_t n, fw_int_width width) {
    const size_t n_padded = padded((uint16_t)n);
    for (size_t i = n; i < n_padded; ++i) values[i] = 0;
    if (width == FW_INT8) fw_dot_order(values, n_padded);
}

fw_status fw_int_mlp_run(const fw_int_mlp* mlp, const float features[], void* scratch,
                         size_t scratch_bytes, float logits[], float probabilities[]) {
    if (mlp == NULL || features == NULL || scratch == NULL || logits == NULL) return FW_ERR_NULL;
    const uint16_t width = widest(mlp);
    if (width == 0) return FW_ERR_SHAPE;
    if (!all_there(mlp)) return FW_ERR_NULL;
    if (mlp->width != FW_INT8 && mlp->width != FW_INT16) return FW_ERR_CONFIG;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_int_mlp_scratch(mlp))) return FW_ERR_SCRATCH;
    if (!fw_all_finite(features, mlp->layer[0].n_in)) return FW_ERR_NONFINITE;

    int16_t* in = scratch;
    int16_t* out = in + padded(width);
    quantise(mlp, features, in);
    const fw_int_layer* const last = &mlp->layer[mlp->n_layers - 1];
    for (const fw_int_layer* layer = mlp->layer;; ++layer) {
        prepare(in, layer->n_in, mlp->width);
        if (layer == last) break;
        hidden_layer(layer, mlp->width, in, out);
        int16_t* const reused = in;
        in = out;
        out = reused;
    }
    last_layer(last, mlp->width, in, logits);
    return probabilities == NULL ? FW_OK : fw_softmax(logits, last->n_out, probabilities);
}

static uint32_t size_of(int32_t value) {
    return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

/* Sum over i of |weight[o][i]|, below 2^31: counts are 16 bits. Beyond the bound of fw_int_layer if
 * the padding is not 0. */
static uint32_t row_size(const fw_int_layer* layer, fw_int_width width, size_t o) {
    const size_t n = fw_int_stride(width, layer->n_in);
    const int8_t* const bytes = (const int8_t*)layer->weight + o * n;
    const int16_t* const halves = (const int16_t*)layer->weight + o * n;
    uint32_t size = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint32_t weight = size_of(width == FW_INT8 ? bytes[i] : halves[i]);
        if (i >= layer->n_in && weight != 0) return UINT32_MAX;
        size += weight;
    }
    return size;
}

static bool row_fits(const fw_int_layer* layer, fw_int_width width, size_t o, bool is_last) {
    const uint64_t most =
        (uint64_t)row_size(layer, width, o) * (uint32_t)largest_of(width) + size_of(layer->bias[o]);
    if (most > INT32_MAX) return false;
    if (is_last) { /* times a sum of 2^31 it stays finite; false for NaN */
        return layer->scale[o] < 1e28f && layer->scale[o] > -1e28f;
    }
    return layer->multiplier[o] >= 0 && layer->shift[o] >= 33 && layer->shift[o] <= 62;
}

fw_status fw_int_layer_check(const fw_int_layer* layer, fw_int_width width, bool is_last) {
    if (layer == NULL || !has_arrays(layer, is_last)) return FW_ERR_NULL;
    if (layer->n_in == 0 || layer->n_out == 0) return FW_ERR_SHAPE;
    for (size_t o = 0; o < layer->n_out; ++o) {
        if (!row_fits(layer, width, o, is_last)) return FW_ERR_VALUE;
    }
    return FW_OK;
}
