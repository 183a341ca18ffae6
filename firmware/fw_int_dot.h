/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_INT_DOT_H
#define FW_INT_DOT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sums of products of integers, two products at a time where the processor can (Cortex-M4: SMLAD),
 * one after the other elsewhere. Sums that fit 32 bits are exact, so both give the same. */

/* sum[r] += sum over i of row[r][i] in[i], for four rows one behind the other.
 *
 * row     (4, n), aligned to 4
 * in      (n), aligned to 4
 * n       a multiple of 2
 * Time: 4 n multiplications. */
void fw_dot_four_int16(const int16_t row[], const int16_t in[], size_t n, int32_t sum[4]);

/* The same of one row. Time: n multiplications. */
int32_t fw_dot_one_int16(const int16_t row[], const int16_t in[], size_t n, int32_t sum);

/* The same with rows of int8, n a multiple of 4, and `in` in the order of fw_dot_order.
 * Time: 4 n multiplications. */
void fw_dot_four_int8(const int8_t row[], const int16_t in[], size_t n, int32_t sum[4]);
/* Likewise of one row. Time: n multiplications. */
int32_t fw_dot_one_int8(const int8_t row[], const int16_t in[], size_t n, int32_t sum);

/* Puts values (n) into the order the int8 sums take them: of every four, the second and third
 * change places, because bytes 0 and 2 of a word are unpacked together, then 1 and 3.
 *
 * n  a multiple of 4
 * Time: n / 4 exchanges. */
void fw_dot_order(int16_t values[], size_t n);

#ifdef __cplusplus
}
#endif

#endif
