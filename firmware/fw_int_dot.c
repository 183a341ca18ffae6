/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_int_dot.h"

#include <string.h>

#if defined(__ARM_FEATURE_SIMD32)
#include <arm_acle.h>
#endif

/* The four bytes at `place`, as they lie in memory; one load instruction. */
static inline uint32_t word_at(const void* place) {
    uint32_t word;
    memcpy(&word, place, sizeof word);
    return word;
}

/* sum + low half of a * low half of b + high half of a * high half of b, halves being signed. */
static inline int32_t dual(uint32_t a, uint32_t b, int32_t sum) {
#if defined(__ARM_FEATURE_SIMD32)
    return __smlad((int16x2_t)a, (int16x2_t)b, sum);
#else
    const int32_t low = (int32_t)(int16_t)(a & 0xFFFFu) * (int16_t)(b & 0xFFFFu);
    const int32_t high = (int32_t)(int16_t)(a >> 16) * (int16_t)(b >> 16);
    return sum + low + high;
#endif
}

/* The signed bytes 0 and 2 of a word as two halves. */
static inline uint32_t even_bytes(uint32_t word) {
#if defined(__ARM_FEATURE_SIMD32)
    return (uint32_t)__sxtb16((int8x4_t)word);
#else
    const uint32_t low = (uint32_t)(int32_t)(int8_t)(word & 0xFFu) & 0xFFFFu;
    const uint32_t high = (uint32_t)(int32_t)(int8_t)(word >> 16 & 0xFFu) & 0xFFFFu;
    return low | high << 16;
#endif
}

static inline uint32_t odd_bytes(uint32_t word) {
    return even_bytes(word >> 8 | word << 24);
}

void fw_dot_four_int16(const int16_t row[], const int16_t in[], size_t n, int32_t sum[4]) {
    const int16_t *row0 = row, *row1 = row + n, *row2 = row + 2 * n, *row3 = row + 3 * n;
    const int16_t* const end = in + n / 4 * 4;
    int32_t sum0 = sum[0], sum1 = sum[1], sum2 = sum[2], sum3 = sum[3];
    while (in != end) { /* four inputs a turn */
        const uint32_t first = word_at(in), second = word_at(in + 2);
        sum0 = dual(word_at(row0 + 2), second, dual(word_at(row0), first, sum0));
        sum1 = dual(word_at(row1 + 2), second, dual(word_at(row1), first, sum1));
        sum2 = dual(word_at(row2 + 2), second, dual(word_at(row2), first, sum2));
        sum3 = dual(word_at(row3 + 2), second, dual(word_at(row3), first, sum3));
        row0 += 4;
        row1 += 4;
        row2 += 4;
        row3 += 4;
        in += 4;
    }
    if (n % 4 != 0) { /* n is even: two are left */
        const uint32_t pair = word_at(in);
        sum0 = dual(word_at(row0), pair, sum0);
        sum1 = dual(word_at(row1), pair, sum1);
        sum2 = dual(word_at(row2), pair, sum2);
        sum3 = dual(word_at(row3), pair, sum3);
    }
    sum[0] = sum0;
    sum[1] = sum1;
    sum[2] = sum2;
    sum[3] = sum3;
}

int32_t fw_dot_one_int16(const int16_t row[], const int16_t in[], size_t n, int32_t sum) {
    for (size_t i = 0; i < n; i += 2) sum = dual(word_at(row + i), word_at(in + i), sum);
    return sum;
}

/* Four products of the word of weights at `row`. */
static inline int32_t dual_int8(const int8_t* row, uint32_t even, uint32_t odd, int32_t sum) {
    const uint32_t word = word_at(row);
    return dual(odd_bytes(word), odd, dual(even_bytes(word), even, sum));
}

void fw_dot_four_int8(const int8_t row[], const int16_t in[], size_t n, int32_t sum[4]) {
    const int8_t *row0 = row, *row1 = row + n, *row2 = row + 2 * n, *row3 = row + 3 * n;
    const int8_t* const end = row + n;
    int32_t sum0 = sum[0], sum1 = sum[1], sum2 = sum[2], sum3 = sum[3];
    for (; row0 != end; row0 += 4, row1 += 4, row2 += 4, row3 += 4, in += 4) {
        const uint32_t even = word_at(in), odd = word_at(in + 2);
        sum0 = dual_int8(row0, even, odd, sum0);
        sum1 = dual_int8(row1, even, odd, sum1);
        sum2 = dual_int8(row2, even, odd, sum2);
        sum3 = dual_int8(row3, even, odd, sum3);
    }
    sum[0] = sum0;
    sum[1] = sum1;
    sum[2] = sum2;
    sum[3] = sum3;
}

int32_t fw_dot_one_int8(const int8_t row[], const int16_t in[], size_t n, int32_t sum) {
    for (size_t i = 0; i < n; i += 4) {
        sum = dual_int8(row + i, word_at(in + i), word_at(in + i + 2), sum);
    }
    return sum;
}

void fw_dot_order(int16_t values[], size_t n) {
    for (size_t i = 0; i < n; i += 4) {
        const int16_t second = values[i + 1];
        values[i + 1] = values[i + 2];
        values[i + 2] = second;
    }
}
