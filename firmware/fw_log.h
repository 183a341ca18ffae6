/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_LOG_H
#define FW_LOG_H

#ifdef __cplusplus
extern "C" {
#endif

/* Natural logarithm, within 1.5 ulp of the true value, without libm: the same bits on every
 * machine.
 *
 * x  a normal number above 0; below FLT_MIN (0 and negative numbers too) the result is that of
 *    FLT_MIN, -87.34, never infinite. Above FLT_MAX it is that of FLT_MAX. NaN gives NaN.
 * Time: constant. */
float fw_log(float x);

#ifdef __cplusplus
}
#endif

#endif
