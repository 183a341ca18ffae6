/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_FINITE_H
#define FW_FINITE_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whether none of values (n) is infinite or NaN. values may be NULL only if n is 0.
 * Time: n comparisons. */
bool fw_all_finite(const float values[], uint16_t n);

#ifdef __cplusplus
}
#endif

#endif
