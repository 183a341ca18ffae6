/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_CLASSIFY_H
#define FW_CLASSIFY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fw_frame.h"
#include "fw_frame_quality.h"
#include "fw_model.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a model makes of one frame.
 *
 * features, logits, probabilities  the first n_features or n_classes values count
 * label        class of the largest logit, the first of equals; its probability
 * energy       fw_energy of the logits
 * squared      squared Mahalanobis distance of the features; 0 without a monitor in the model
 * suspicious   the frame was saturated or dead, or squared is above the model's limit: count it
 * with fw_drift_update, and do not rely on the label */
typedef struct fw_result {
    fw_frame_quality quality;
    uint16_t label;
    bool suspicious;
    float probability, max_logit, energy, squared;
    float features[FW_MODEL_MAX_FEATURES];
    float logits[FW_MODEL_MAX_CLASSES];
    float probabilities[FW_MODEL_MAX_CLASSES];
} fw_result;

/* Bytes of scratch fw_classify needs with an opened model; 0 if model is NULL. Time: constant. */
size_t fw_classify_scratch(const fw_model* model);

/* frame -> result: inspection, descriptor, normalisation, network, softmax, monitors.
 *
 * model    opened by fw_model_open
 * scratch  scratch_bytes >= fw_classify_scratch(model), aligned to 4; contents do not matter
 *
 * FW_ERR_NULL       a pointer, or frame->samples, is NULL
 * FW_ERR_GEOMETRY   the frame has another shape than the model's
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a logit is beyond the range of float: no frame like those trained on
 * Time: the sum of its stages, all bounded by the model's counts. */
fw_status fw_classify(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, fw_result* result);

/* The parts of fw_classify between frame and logits, for those who time or replace them. Scratch
 * and errors as there. */
fw_status fw_describe(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, float features[]);
fw_status fw_infer(const fw_model* model, const float features[], void* scratch,
                   size_t scratch_bytes, float logits[], float probabilities[]);

#ifdef __cplusplus
}
#endif

#endif
