/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_log.h"

#include <math.h>
#include <stdint.h>

#include "fw_strict_float.h"

#define LN2_HIGH 0.693359375f /* 10 bits: its product with any exponent is exact */
#define LN2_LOW -2.12194440e-4f
#define SQRT_HALF_BITS 0x3f3504f3u /* of the float nearest to sqrt(1/2) */
#define ONE_BITS 0x3f800000u
#define MANTISSA_BITS 0x007fffffu

typedef union float_bits {
    float value;
    uint32_t bits;
} float_bits;

/* ln(1 + f) for 1 + f in [sqrt(1/2), sqrt(2)): with s = f / (2 + f) it is 2 artanh(s), whose series
 * in s^2 <= 0.0295 is cut where a term is below 0.1 ulp. */
static float log_near_one(float f) {
    const float s = f / (2.0f + f);
    const float s2 = s * s;
    float tail = 2.0f / 9.0f;
    tail = tail * s2 + 2.0f / 7.0f;
    tail = tail * s2 + 2.0f / 5.0f;
    tail = tail * s2 + 2.0f / 3.0f;
    /* 2 s = f - s f: the exact f carries most of the result */
    return f - s * (f - s2 * tail);
}

float fw_log(float x) {
    if (isnan(x)) return x;
    float_bits number = {.value = x < FLT_MIN ? FLT_MIN : x > FLT_MAX ? FLT_MAX : x};
    /* Counted from sqrt(1/2), the exponent field steps where the mantissa must start anew. */
    const uint32_t shifted = number.bits + (ONE_BITS - SQRT_HALF_BITS);
    const int32_t exponent = (int32_t)(shifted >> 23) - 127;
    number.bits = (shifted & MANTISSA_BITS) + SQRT_HALF_BITS;
    const float near_one = log_near_one(number.value - 1.0f);
    const float whole = (float)exponent;
    return whole * LN2_HIGH + (whole * LN2_LOW + near_one);
}
