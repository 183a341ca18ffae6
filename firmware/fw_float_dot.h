/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_FLOAT_DOT_H
#define FW_FLOAT_DOT_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sum[r] = bias[r] + sum over i of row[r][i] in[i], for four rows one behind the other; if
 * rectified, a negative sum becomes 0 and NaN stays NaN. The order within every sum is that of the
 * plain loop: bias, then rising i, each product rounded before it is added.
 *
 * row        (4, n)
 * in         (n)
 * bias, sum  (4)
 * Time: 4 n multiplications. */
void fw_dot_four_float(const float row[], const float in[], size_t n, const float bias[4],
                       bool rectified, float sum[4]);

#ifdef __cplusplus
}
#endif

#endif
