/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_finite.h"

#include <math.h>
#include <stddef.h>

#include "fw_strict_float.h"

bool fw_all_finite(const float values[], uint16_t n) {
    for (size_t i = 0; i < n; ++i) {
        if (!isfinite(values[i])) return false;
    }
    return true;
}
