/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_model_arrays.h"

#include <stdbool.h>
#include <string.h>

#include "fw_finite.h"
#include "fw_strict_float.h"

/* n_values of value_bytes each, in place, padded to a multiple of 4; NULL if the blob ends first.
 */
static const void* take(fw_blob_rest* rest, size_t n_values, size_t value_bytes) {
    const size_t n_bytes = (n_values * value_bytes + 3) / 4 * 4; /* < 2^32: counts are 16 bits */
    if (n_values > UINT32_MAX / 8 || n_bytes > rest->n_left) return NULL;
    const void* const place = rest->next;
    rest->next += n_bytes;
    rest->n_left -= n_bytes;
    return place;
}

/* So many floats, all finite, written to *out. */
static fw_status take_floats(fw_blob_rest* rest, size_t n, const float** out) {
    const float* const values = take(rest, n, sizeof(float));
    if (values == NULL) return FW_ERR_LENGTH;
    for (size_t i = 0; i < n; ++i) {
        if (!fw_all_finite(&values[i], 1)) return FW_ERR_VALUE;
    }
    *out = values;
    return FW_OK;
}

/* Text of one byte at least, then zeros to the end, one at least. RFC 3629, section 4: behind the
 * lead of a sequence come one to three bytes of 80..BF, the first of them in a narrower range where
 * the form would be overlong, a surrogate or beyond U+10FFFF. */
static bool is_name(const uint8_t name[FW_MODEL_NAME_BYTES]) {
    uint32_t n_more = 0, low = 0x80, high = 0xBF;
    bool ended = false;
    for (size_t i = 0; i < FW_MODEL_NAME_BYTES; ++i) {
        const uint32_t byte = name[i];
        if (n_more > 0) {
            if (byte < low || byte > high) return false;
            low = 0x80;
            high = 0xBF;
            --n_more;
        } else if (ended || byte == 0) {
            if (i == 0 || byte != 0) return false;
            ended = true;
        } else if (byte >= 0x80) {
            if (byte < 0xC2 || byte > 0xF4) return false;
            n_more = byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
            if (byte == 0xE0) low = 0xA0;
            if (byte == 0xED) high = 0x9F;
            if (byte == 0xF0) low = 0x90;
            if (byte == 0xF4) high = 0x8F;
        }
    }
    return ended;
}

static fw_status read_names(fw_blob_rest* rest, fw_model* model) {
    for (size_t c = 0; c < model->n_classes; ++c) {
        const char* const name = take(rest, FW_MODEL_NAME_BYTES, 1);
        if (name == NULL) return FW_ERR_LENGTH;
        if (!is_name((const uint8_t*)name)) return FW_ERR_NAME;
        for (size_t other = 0; other < c; ++other) {
            if (memcmp(name, model->class_name[other], FW_MODEL_NAME_BYTES) == 0) {
                return FW_ERR_NAME;
            }
        }
        model->class_name[c] = name;
    }
    return FW_OK;
}

static fw_status check_widths(const fw_model_widths* widths, const fw_model* model) {
    if (widths->n_layers < 1 || widths->n_layers > FW_MLP_MAX_LAYERS) return FW_ERR_SHAPE;
    for (size_t i = 0; i < FW_MLP_MAX_LAYERS; ++i) {
        if ((widths->n_out[i] != 0) != (i < widths->n_layers)) return FW_ERR_SHAPE;
    }
    return widths->n_out[widths->n_layers - 1] == model->n_classes ? FW_OK : FW_ERR_SHAPE;
}

/* Whether a number that is not used is what it must be then: zero bits. */
static bool is_positive_zero(float value) {
    static const float zero = 0.0f;
    return memcmp(&value, &zero, sizeof value) == 0;
}

static fw_status read_real_layer(fw_blob_rest* rest, fw_layer* layer) {
    const size_t n_weights = (size_t)layer->n_out * layer->n_in;
    const fw_status weights = take_floats(rest, n_weights, &layer->weight);
    return weights != FW_OK ? weights : take_floats(rest, layer->n_out, &layer->bias);
}

static fw_status read_int_layer(fw_blob_rest* rest, fw_int_width width, bool is_last,
                                fw_int_layer* layer) {
    const size_t n_weights = (size_t)layer->n_out * fw_int_stride(width, layer->n_in);
    layer->weight = take(rest, n_weights, width == FW_INT8 ? sizeof(int8_t) : sizeof(int16_t));
    if (layer->weight == NULL) return FW_ERR_LENGTH;
    layer->bias = take(rest, layer->n_out, sizeof(int32_t));
    if (layer->bias == NULL) return FW_ERR_LENGTH;
    if (is_last) {
        const fw_status scales = take_floats(rest, layer->n_out, &layer->scale);
        if (scales != FW_OK) return scales;
    } else {
        layer->multiplier = take(rest, layer->n_out, sizeof(int32_t));
        if (layer->multiplier == NULL) return FW_ERR_LENGTH;
        layer->shift = take(rest, layer->n_out, sizeof(int32_t));
        if (layer->shift == NULL) return FW_ERR_LENGTH;
    }
    return fw_int_layer_check(layer, width, is_last);
}

static fw_status read_network(fw_blob_rest* rest, const fw_model_widths* widths, fw_model* model) {
    const float *mean = NULL, *scale = NULL;
    const fw_status means = take_floats(rest, model->n_features, &mean);
    if (means != FW_OK) return means;
    const fw_status scales = take_floats(rest, model->n_features, &scale);
    if (scales != FW_OK) return scales;

    for (size_t i = 0; i < model->n_features; ++i) {
        if (scale[i] < 0.0f) return FW_ERR_VALUE;
    }

    const bool real = model->arithmetic == FW_ARITHMETIC_FLOAT;
    if (real && !is_positive_zero(model->whole.input_levels)) return FW_ERR_VALUE;
    const fw_int_width width = model->arithmetic == FW_ARITHMETIC_INT8 ? FW_INT8 : FW_INT16;
    if (!real && !(model->whole.input_levels > 0.0f && model->whole.input_levels <= FLT_MAX)) {
        return FW_ERR_VALUE;
    }
    uint16_t n_in = model->n_features;
    for (size_t i = 0; i < widths->n_layers; ++i) {
        const uint16_t n_out = widths->n_out[i];
        model->real.layer[i] = (fw_layer){.n_in = n_in, .n_out = n_out};
        model->whole.layer[i] = (fw_int_layer){.n_in = n_in, .n_out = n_out};
        const fw_status status =
            real ? read_real_layer(rest, &model->real.layer[i])
                 : read_int_layer(rest, width, i + 1 == widths->n_layers, &model->whole.layer[i]);
        if (status != FW_OK) return status;
        n_in = n_out;
    }
    model->real.n_layers = model->whole.n_layers = widths->n_layers;
    model->real.input_mean = model->whole.input_mean = mean;
    model->real.input_scale = model->whole.input_scale = scale;
    model->whole.width = width;
    return FW_OK;
}

static fw_status read_monitor(fw_blob_rest* rest, fw_model* model) {
    if (!(model->suspicious_squared > 0.0f && model->suspicious_squared <= FLT_MAX)) {
        return FW_ERR_VALUE;
    }
    const size_t n = model->n_features;
    fw_mahalanobis* const monitor = &model->monitor;
    monitor->n_features = model->n_features;
    monitor->n_classes = model->n_classes;
    fw_status status = take_floats(rest, n, &monitor->mean);
    if (status == FW_OK) status = take_floats(rest, n * (n + 1) / 2, &monitor->whitening);
    if (status == FW_OK) status = take_floats(rest, model->n_classes * n, &monitor->centre);
    return status;
}

fw_status fw_model_read_arrays(fw_blob_rest* rest, const fw_model_widths* widths, fw_model* model) {
    fw_status status = check_widths(widths, model);
    if (status == FW_OK) status = read_names(rest, model);
    if (status == FW_OK) status = read_network(rest, widths, model);
    if (status == FW_OK && model->has_monitor) status = read_monitor(rest, model);
    if (status != FW_OK) return status;
    if (!model->has_monitor && !is_positive_zero(model->suspicious_squared)) return FW_ERR_VALUE;
    return rest->n_left == 0 ? FW_OK : FW_ERR_LENGTH;
}
