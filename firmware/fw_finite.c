/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_finite.h"

#include <stddef.h>
#include <string.h>

#include "fw_strict_float.h"

#define EXPONENT 0x7F800000u /* all ones in infinities and NaN alone */

bool fw_all_finite(const float values[], uint16_t n) {
    for (const float* const end = values + n; values != end; ++values) {
        uint32_t bits;
        memcpy(&bits, values, sizeof bits); /* compared as an integer: no flags to fetch */
        if ((~bits & EXPONENT) == 0) return false;
    }
    return true;
}
