/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_EXP_H
#define FW_EXP_H

#ifdef __cplusplus
extern "C" {
#endif

/* exp(x), within 1.03 ulp of the true value, without libm: the same bits on every machine.
 *
 * x  any float, dimensionless. Below ln(FLT_MIN) = -87.34 the result is 0, never subnormal;
 *    above 88.72283, just under ln(FLT_MAX), it is FLT_MAX, never infinite. NaN gives NaN.
 * Time: constant. */
float fw_exp(float x);

#ifdef __cplusplus
}
#endif

#endif
