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
 * quality      of the samples; all 0 where there were none (fw_classify_bins)
 * n_saturated_bins  fw_extract_counted: what the HWA-like transform cut off; 0 with the float one,
 *                   and so for peak shapes
 * n_clipped_inputs  fw_int_clipped: features beyond the reach of an integer network; 0 in float32
 * label        class of the largest logit, the first of equals; its probability
 * energy       fw_energy of the logits, nepers
 * squared      squared Mahalanobis distance of the features; 0 without a monitor in the model
 * suspicious   samples, bins or inputs were cut off, a row was dead, or squared is above the
 *              model's limit: count it with fw_drift_update, and do not rely on the label */
typedef struct fw_result {
    fw_frame_quality quality;
    uint32_t n_saturated_bins;
    uint16_t n_clipped_inputs;
    uint16_t label;
    bool suspicious;
    float probability, max_logit, energy, squared;
    float features[FW_MODEL_MAX_FEATURES];
    float logits[FW_MODEL_MAX_CLASSES];
    float probabilities[FW_MODEL_MAX_CLASSES];
} fw_result;

/* Bytes of scratch fw_classify needs with an opened model; 0 if model is NULL. Time: constant. */
size_t fw_classify_scratch(const fw_model* model);

/* frame -> result: inspection, descriptor and normalisation or the peak's shape, network, softmax,
 * monitors.
 *
 * model    opened by fw_model_open
 * scratch  scratch_bytes >= fw_classify_scratch(model), aligned to 4; contents do not matter
 *
 * FW_ERR_NULL       a pointer, or frame->samples, is NULL
 * FW_ERR_GEOMETRY   the frame has another shape than the model's
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a logit is beyond the range of float: no frame like those trained on; or, for
 *                   peak shapes, a row without any echo, as a dead one is (fw_relative)
 * Time: the sum of its stages, all bounded by the model's counts. */
fw_status fw_classify(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, fw_result* result);

/* Bytes of scratch fw_classify_bins needs with an opened model: the network's alone. 0 if model is
 * NULL. Time: constant. */
size_t fw_classify_bins_scratch(const fw_model* model);

/* Amplitudes of range bins -> result: all of fw_classify that follows the range transform, for
 * those whose spectrum comes from elsewhere (the accelerator's radar cube, a profile of TLV 302).
 *
 * spectrum  amplitudes >= 0 in LSB, as fw_extract gives them, of bins that hold
 *           model->search_first .. model->search_first + model->n_search - 1; from bin 0 on is
 *           always enough. Averaged over rows as model->descriptor.integration says; for
 *           FW_INTEGRATE_EXPORTED made of whole counts by fw_exported_to_amplitude
 * scratch   scratch_bytes >= fw_classify_bins_scratch(model), aligned to 4; contents do not matter
 * Nobody has seen the samples: quality and n_saturated_bins are 0, and suspicious rests on the
 * rest. Where bins may have been cut off, the caller must say so to fw_drift_update itself.
 *
 * FW_ERR_NULL       a pointer, or spectrum->amplitude, is NULL
 * FW_ERR_CONFIG     the model sees the shape of the peak: amplitudes do not tell its phases
 * FW_ERR_SHAPE      the spectrum does not hold the model's bins
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  an amplitude is infinite, NaN or so large that a result would be; or a logit
 * Time: fw_normalise of n_search bins, the network, one fw_softmax, the monitors. */
fw_status fw_classify_bins(const fw_model* model, const fw_bins* spectrum, void* scratch,
                           size_t scratch_bytes, fw_result* result);

/* frame -> features, the first half of fw_classify, for those who time or replace it.
 *
 * scratch   scratch_bytes >= fw_classify_scratch(model), aligned to 4; contents do not matter
 * features  out: (model->n_features), LSB, or nepers with model->normalise.logarithm; for peak
 *           shapes as fw_relative gives them
 *
 * FW_ERR_NULL, FW_ERR_GEOMETRY, FW_ERR_SCRATCH  as fw_classify
 * FW_ERR_NONFINITE  peak shapes alone: a row without any echo
 * Time: fw_extract of n_search bins, then fw_normalise; or fw_relative. */
fw_status fw_describe(const fw_model* model, const fw_frame* frame, void* scratch,
                      size_t scratch_bytes, float features[]);

/* features -> logits, and probabilities if wanted: the network alone. It neither normalises
 * (fw_normalise) nor looks at any monitor: fw_classify_bins does.
 *
 * features       (model->n_features), finite, as fw_describe gives them
 * scratch        scratch_bytes >= fw_classify_bins_scratch(model), aligned to 4
 * logits         out: (model->n_classes), dimensionless
 * probabilities  out: the same shape, by fw_softmax; or NULL
 *
 * FW_ERR_NULL       a pointer other than probabilities is NULL
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_NONFINITE  a feature is infinite or NaN, or a logit would be
 * Time: as fw_mlp_run or fw_int_mlp_run: the sum of n_in * n_out multiplications over the layers,
 * and one fw_softmax if wanted. */
fw_status fw_infer(const fw_model* model, const float features[], void* scratch,
                   size_t scratch_bytes, float logits[], float probabilities[]);

#ifdef __cplusplus
}
#endif

#endif
