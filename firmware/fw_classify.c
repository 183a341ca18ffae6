/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_classify.h"

#include "fw_scratch.h"
#include "fw_softmax.h"
#include "fw_strict_float.h"

static size_t larger(size_t a, size_t b) {
    return a > b ? a : b;
}

static size_t network_scratch(const fw_model* model) {
    return model->arithmetic == FW_ARITHMETIC_FLOAT ? fw_mlp_scratch(&model->real)
                                                    : fw_int_mlp_scratch(&model->whole);
}

static fw_frame frame_shape(const fw_model* model) {
    return (fw_frame){.samples = NULL,
                      .n_chirps = model->chirp.n_chirps,
                      .n_rx = model->chirp.n_rx,
                      .n_samples = model->chirp.n_samples};
}

static size_t extract_scratch(const fw_model* model) {
    const fw_frame shape = frame_shape(model);
    return fw_extract_scratch(&shape);
}

/* Of range bins, the profile in which a peak is looked for, then what its extraction or the network
 * needs. */
size_t fw_classify_scratch(const fw_model* model) {
    if (model == NULL) return 0;
    if (model->kind == FW_FEATURES_PEAK_SHAPE) {
        const fw_frame shape = frame_shape(model);
        return larger(fw_relative_scratch(&shape), network_scratch(model));
    }
    return model->n_search * sizeof(float) + larger(extract_scratch(model), network_scratch(model));
}

size_t fw_classify_bins_scratch(const fw_model* model) {
    return model == NULL ? 0 : network_scratch(model);
}

/* The profile in which a peak is looked for -> features. */
static fw_status normalise(const fw_model* model, const float profile[], float features[]) {
    const fw_bins bins = {
        .amplitude = profile, .first_bin = model->search_first, .n_bins = model->n_search};
    return fw_normalise(&bins, &model->normalise, model->descriptor.first_bin, model->n_features,
                        features);
}

static fw_status describe(const fw_model* model, const fw_frame* frame, void* scratch,
                          size_t scratch_bytes, float features[], uint32_t* n_saturated) {
    const fw_status refused = fw_model_accepts_frame(model, frame);
    if (refused != FW_OK) return refused;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_classify_scratch(model))) {
        return FW_ERR_SCRATCH;
    }
    if (model->kind == FW_FEATURES_PEAK_SHAPE) {
        return fw_relative(frame, &model->shape, scratch, scratch_bytes, features);
    }
    float* const profile = scratch;
    fw_extract_config wide = model->descriptor;
    wide.first_bin = model->search_first;
    wide.n_bins = model->n_search;
    const fw_status failed = fw_extract_counted(frame, &wide, profile + model->n_search,
                                                extract_scratch(model), profile, n_saturated);
    return failed != FW_OK ? failed : normalise(model, profile, features);
}

fw_status fw_describe(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, float features[]) {
    if (model == NULL || frame == NULL || scratch == NULL || features == NULL) return FW_ERR_NULL;
    if (frame->samples == NULL) return FW_ERR_NULL;
    uint32_t n_saturated = 0;
    return describe(model, frame, scratch, scratch_bytes, features, &n_saturated);
}

fw_status fw_infer(const fw_model* model, const float features[], void* scratch,
                   size_t scratch_bytes, float logits[], float probabilities[]) {
    if (model == NULL) return FW_ERR_NULL;
    return model->arithmetic == FW_ARITHMETIC_FLOAT
               ? fw_mlp_run(&model->real, features, scratch, scratch_bytes, logits, probabilities)
               : fw_int_mlp_run(&model->whole, features, scratch, scratch_bytes, logits,
                                probabilities);
}

/* What the logits and features in result say of themselves. */
static fw_status judge(const fw_model* model, fw_result* result) {
    result->label = fw_argmax(result->logits, model->n_classes);
    result->probability = result->probabilities[result->label];
    result->max_logit = fw_max_logit(result->logits, model->n_classes);
    const fw_status failed = fw_energy(result->logits, model->n_classes, &result->energy);
    if (failed != FW_OK) return failed;
    if (model->arithmetic != FW_ARITHMETIC_FLOAT) {
        result->n_clipped_inputs = fw_int_clipped(&model->whole, result->features);
    }
    result->suspicious = result->quality.n_saturated > 0 || result->quality.n_dead_rows > 0 ||
                         result->n_saturated_bins > 0 || result->n_clipped_inputs > 0;
    if (!model->has_monitor) return FW_OK;
    const fw_status lost =
        fw_mahalanobis_squared(&model->monitor, result->features, &result->squared);
    if (result->squared > model->suspicious_squared) result->suspicious = true;
    return lost;
}

/* From the features in result on. */
static fw_status conclude(const fw_model* model, void* scratch, size_t scratch_bytes,
                          fw_result* result) {
    const fw_status failed = fw_infer(model, result->features, scratch, scratch_bytes,
                                      result->logits, result->probabilities);
    return failed != FW_OK ? failed : judge(model, result);
}

fw_status fw_classify_bins(const fw_model* model, const fw_bins* spectrum, void* scratch,
                           size_t scratch_bytes, fw_result* result) {
    if (model == NULL || spectrum == NULL || scratch == NULL || result == NULL) return FW_ERR_NULL;
    if (spectrum->amplitude == NULL) return FW_ERR_NULL;
    if (model->kind != FW_FEATURES_RANGE_BINS) return FW_ERR_CONFIG;
    const uint32_t end = (uint32_t)spectrum->first_bin + spectrum->n_bins;
    const uint32_t search_end = (uint32_t)model->search_first + model->n_search;
    if (spectrum->first_bin > model->search_first || end < search_end) return FW_ERR_SHAPE;
    const float* const profile = spectrum->amplitude + (model->search_first - spectrum->first_bin);
    fw_result found = {0};
    fw_status status = normalise(model, profile, found.features);
    if (status == FW_OK) status = conclude(model, scratch, scratch_bytes, &found);
    if (status == FW_OK) *result = found;
    return status;
}

fw_status fw_classify(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, fw_result* result) {
    if (model == NULL || frame == NULL || scratch == NULL || result == NULL) return FW_ERR_NULL;
    if (frame->samples == NULL) return FW_ERR_NULL;
    fw_result found = {0};
    fw_status status = fw_model_accepts_frame(model, frame);
    if (status == FW_OK) status = fw_frame_inspect(frame, model->chirp.adc_bits, &found.quality);
    if (status == FW_OK) {
        status =
            describe(model, frame, scratch, scratch_bytes, found.features, &found.n_saturated_bins);
    }
    if (status == FW_OK) status = conclude(model, scratch, scratch_bytes, &found);
    if (status == FW_OK) *result = found;
    return status;
}
