/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_exp.h"

#include <math.h>
#include <stdint.h>

#include "fw_strict_float.h"

#define LOWEST_X -87.336544f /* ln(FLT_MIN), rounded towards zero */
#define HIGHEST_X 88.72283f
#define LOG2_E 1.44269504f
#define LN2_HIGH 0.693359375f /* 10 bits: its product with any exponent is exact */
#define LN2_LOW -2.12194440e-4f

/* 2^n, n = -126..127, made of its bits. */
static float power_of_two(int32_t n) {
    const union {
        uint32_t bits;
        float value;
    } power = {.bits = (uint32_t)(n + 127) << 23};
    return power.value;
}

/* exp(r) for |r| <= ln(2)/2, by its Taylor series: the first term left out is below 0.1 ulp. */
static float exp_near_zero(float r) {
    float tail = 1.0f / 5040.0f;
    tail = tail * r + 1.0f / 720.0f;
    tail = tail * r + 1.0f / 120.0f;
    tail = tail * r + 1.0f / 24.0f;
    tail = tail * r + 1.0f / 6.0f;
    tail = tail * r + 0.5f;
    return 1.0f + (r + r * r * tail);
}

float fw_exp(float x) {
    if (isnan(x)) return x;
    if (x < LOWEST_X) return 0.0f;
    if (x > HIGHEST_X) return FLT_MAX;
    const float turns = x * LOG2_E;
    const int32_t n = (int32_t)(turns < 0.0f ? turns - 0.5f : turns + 0.5f);
    const float r = x - (float)n * LN2_HIGH - (float)n * LN2_LOW;
    /* Two factors, since 2^128 is not a float. */
    return exp_near_zero(r) * power_of_two(n / 2) * power_of_two(n - n / 2);
}
