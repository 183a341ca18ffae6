/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_monitor.h"

#include <math.h>

#include "fw_exp.h"
#include "fw_finite.h"
#include "fw_log.h"
#include "fw_softmax.h"
#include "fw_strict_float.h"

float fw_max_logit(const float logits[], uint16_t n) {
    return logits == NULL || n == 0 ? 0.0f : logits[fw_argmax(logits, n)];
}

fw_status fw_energy(const float logits[], uint16_t n, float* energy) {
    if (logits == NULL || energy == NULL) return FW_ERR_NULL;
    if (n == 0) return FW_ERR_SHAPE;
    if (!fw_all_finite(logits, n)) return FW_ERR_NONFINITE;
    const float largest = fw_max_logit(logits, n);
    float sum = 0.0f; /* becomes 1 or more: the largest logit contributes exp(0) */
    for (size_t i = 0; i < n; ++i) sum += fw_exp(logits[i] - largest);
    *energy = -(largest + fw_log(sum));
    return FW_OK;
}

/* z (n) = W (features - mean); each sum runs by rising column. */
static void whiten(const fw_mahalanobis* monitor, const float features[], float z[]) {
    const float* row = monitor->whitening;
    for (size_t i = 0; i < monitor->n_features; ++i) {
        float sum = 0.0f;
        for (size_t j = 0; j <= i; ++j) sum += row[j] * (features[j] - monitor->mean[j]);
        z[i] = sum;
        row += i + 1;
    }
}

static float squared_distance(const float a[], const float b[], size_t n) {
    float sum = 0.0f;
    for (size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

fw_status fw_mahalanobis_squared(const fw_mahalanobis* monitor, const float features[],
                                 float* squared) {
    if (monitor == NULL || features == NULL || squared == NULL) return FW_ERR_NULL;
    if (monitor->mean == NULL || monitor->whitening == NULL || monitor->centre == NULL) {
        return FW_ERR_NULL;
    }
    const uint16_t n = monitor->n_features;
    if (n == 0 || n > FW_MAHALANOBIS_MAX_FEATURES || monitor->n_classes == 0) return FW_ERR_SHAPE;
    if (!fw_all_finite(features, n)) return FW_ERR_NONFINITE;

    float z[FW_MAHALANOBIS_MAX_FEATURES];
    whiten(monitor, features, z);
    float nearest = squared_distance(z, monitor->centre, n);
    for (size_t c = 1; c < monitor->n_classes; ++c) {
        const float distance = squared_distance(z, monitor->centre + c * n, n);
        if (!(distance >= nearest)) nearest = distance; /* so that NaN is kept */
    }
    if (!isfinite(nearest)) return FW_ERR_NONFINITE;
    *squared = nearest;
    return FW_OK;
}

bool fw_drift_update(fw_drift* drift, bool suspicious) {
    if (drift == NULL) return false;
    if (suspicious) {
        const uint32_t raised = (uint32_t)drift->level + drift->rise;
        drift->level = raised > drift->limit ? drift->limit : (uint16_t)raised;
    } else {
        drift->level = drift->level > drift->fall ? (uint16_t)(drift->level - drift->fall) : 0;
    }
    if (drift->level == drift->limit) drift->alarm = true;
    if (drift->level == 0) drift->alarm = false;
    return drift->alarm;
}
