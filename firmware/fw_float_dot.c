/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_float_dot.h"

#include "fw_strict_float.h"

/* Each input is loaded once for four sums, which do not wait for each other; four inputs a turn, so
 * that counting and jumping cost little. In a file of its own, so that a compiler gives it all its
 * registers. */
void fw_dot_four_float(const float row[], const float in[], size_t n, const float bias[4],
                       bool rectified, float sum[4]) {
    const float *row0 = row, *row1 = row + n, *row2 = row + 2 * n, *row3 = row + 3 * n;
    const float* const end = in + n / 4 * 4;
    float sum0 = bias[0], sum1 = bias[1], sum2 = bias[2], sum3 = bias[3];
    while (in != end) {
        const float a = in[0], b = in[1], c = in[2], d = in[3];
        sum0 += row0[0] * a;
        sum1 += row1[0] * a;
        sum2 += row2[0] * a;
        sum3 += row3[0] * a;
        sum0 += row0[1] * b;
        sum1 += row1[1] * b;
        sum2 += row2[1] * b;
        sum3 += row3[1] * b;
        sum0 += row0[2] * c;
        sum1 += row1[2] * c;
        sum2 += row2[2] * c;
        sum3 += row3[2] * c;
        sum0 += row0[3] * d;
        sum1 += row1[3] * d;
        sum2 += row2[3] * d;
        sum3 += row3[3] * d;
        row0 += 4;
        row1 += 4;
        row2 += 4;
        row3 += 4;
        in += 4;
    }
    for (size_t i = 0; i < n % 4; ++i) {
        sum0 += row0[i] * in[i];
        sum1 += row1[i] * in[i];
        sum2 += row2[i] * in[i];
        sum3 += row3[i] * in[i];
    }
    if (rectified) {
        if (sum0 < 0.0f) sum0 = 0.0f;
        if (sum1 < 0.0f) sum1 = 0.0f;
        if (sum2 < 0.0f) sum2 = 0.0f;
        if (sum3 < 0.0f) sum3 = 0.0f;
    }
    sum[0] = sum0;
    sum[1] = sum1;
    sum[2] = sum2;
    sum[3] = sum3;
}
