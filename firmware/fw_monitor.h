/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_MONITOR_H
#define FW_MONITOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How far to believe a class: scores of the logits, a distance of the inputs, a count over time. */

/* Largest of logits (n), the simplest confidence; low means unsure. 0 if logits is NULL or n is 0.
 * Time: n comparisons. */
float fw_max_logit(const float logits[], uint16_t n);

/* Free energy -ln(sum over i of exp(logits[i])), in nepers; high means unfamiliar.
 * W. Liu et al., Energy-based out-of-distribution detection, NeurIPS 2020, equation (4), T = 1.
 *
 * FW_ERR_NULL       logits or energy is NULL
 * FW_ERR_SHAPE      n is 0
 * FW_ERR_NONFINITE  a logit is infinite or NaN
 * Time: n exponentials and a logarithm. */
fw_status fw_energy(const float logits[], uint16_t n, float* energy);

#define FW_MAHALANOBIS_MAX_FEATURES 64

/* The spread of the training features: class means and one covariance S that all classes share.
 * With the lower triangular W such that W S W^T = 1, the Mahalanobis distance is a plain one.
 *
 * n_features  1..FW_MAHALANOBIS_MAX_FEATURES
 * n_classes   1..65535
 * mean        (n_features), of all training rows, unit of the features
 * whitening   (n_features (n_features + 1) / 2), rows of W from its first column to the diagonal
 * centre      (n_classes, n_features): W (class mean - mean) */
typedef struct fw_mahalanobis {
    uint16_t n_features, n_classes;
    const float* mean;
    const float* whitening;
    const float* centre;
} fw_mahalanobis;

/* Squared Mahalanobis distance of features from the nearest class; about n_features for a familiar
 * input. K. Lee et al., A simple unified framework for detecting out-of-distribution samples,
 * NeurIPS 2018, equation (2), on the inputs instead of on hidden layers.
 *
 * features  (n_features), finite
 * squared   out: >= 0
 *
 * FW_ERR_NULL       any pointer is NULL
 * FW_ERR_SHAPE      a count out of range
 * FW_ERR_NONFINITE  a feature is infinite or NaN, or the distance would be
 * Time: n_features (n_features + 1) / 2 + n_classes * n_features multiplications. Stack: 256 bytes
 * for the whitened features. */
fw_status fw_mahalanobis_squared(const fw_mahalanobis* monitor, const float features[],
                                 float* squared);

/* A leaky count of suspicious frames: one of them says little, many of them say that the mounting
 * has changed. level rises by `rise` for a suspicious frame and falls by `fall` for any other; the
 * alarm comes at `limit` and goes at 0. In the long run it comes if more than fall / (rise + fall)
 * of the frames are suspicious.
 *
 * rise, fall, limit  1..65535; the caller zeroes level and alarm at the start */
typedef struct fw_drift {
    uint16_t rise, fall, limit;
    uint16_t level;
    bool alarm;
} fw_drift;

/* Counts one frame; returns whether there is an alarm (false for NULL). Time: constant. */
bool fw_drift_update(fw_drift* drift, bool suspicious);

#ifdef __cplusplus
}
#endif

#endif
