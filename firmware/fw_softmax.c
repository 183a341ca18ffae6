/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_softmax.h"

#include <stddef.h>

#include "fw_exp.h"
#include "fw_finite.h"
#include "fw_strict_float.h"

fw_status fw_softmax(const float logits[], uint16_t n, float probabilities[]) {
    if (logits == NULL || probabilities == NULL) return FW_ERR_NULL;
    if (n == 0) return FW_ERR_SHAPE;
    if (!fw_all_finite(logits, n)) return FW_ERR_NONFINITE;

    const float largest = logits[fw_argmax(logits, n)];
    float sum = 0.0f; /* becomes 1 or more: the largest logit contributes exp(0) */
    for (size_t i = 0; i < n; ++i) {
        probabilities[i] = fw_exp(logits[i] - largest);
        sum += probabilities[i];
    }
    for (size_t i = 0; i < n; ++i) probabilities[i] /= sum;
    return FW_OK;
}

uint16_t fw_argmax(const float values[], uint16_t n) {
    uint16_t best = 0;
    if (values == NULL) return best;
    for (uint16_t i = 1; i < n; ++i) {
        if (values[i] > values[best]) best = i;
    }
    return best;
}
