/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_STRICT_FLOAT_H
#define FW_STRICT_FLOAT_H

/* Included by every file that computes: refuses compiler modes in which the same source gives other
 * bits on other machines. Contraction to FMA leaves no macro to test: -ffp-contract=off is the
 * caller's duty (README.md). */

#include <float.h>

#ifdef __FAST_MATH__
#error "firmware/ must not be compiled with -ffast-math"
#endif

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "firmware/ must not be compiled with -ffinite-math-only: it rejects infinities and NaN"
#endif

#if FLT_EVAL_METHOD != 0
#error "firmware/ needs float arithmetic in float, not in a wider register"
#endif

_Static_assert(sizeof(float) == 4 && FLT_MANT_DIG == 24, "float must be IEEE 754 binary32");

#endif
