/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_SOFTMAX_H
#define FW_SOFTMAX_H

#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* probabilities[i] = exp(logits[i] - m) / sum over j of exp(logits[j] - m), m the largest logit.
 *
 * logits         (n), finite, dimensionless
 * n              1..65535
 * probabilities  out: (n), each 0..1; may be the same array as logits
 *
 * FW_ERR_NULL       logits or probabilities is NULL
 * FW_ERR_SHAPE      n is 0
 * FW_ERR_NONFINITE  a logit is infinite or NaN
 * Time: n exponentials and n divisions. */
fw_status fw_softmax(const float logits[], uint16_t n, float probabilities[]);

/* Index of the largest of values (n), finite; of equals, the lowest index. 0 if values is NULL or
 * n is 0. Time: n comparisons. */
uint16_t fw_argmax(const float values[], uint16_t n);

#ifdef __cplusplus
}
#endif

#endif
