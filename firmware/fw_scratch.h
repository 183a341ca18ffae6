/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_SCRATCH_H
#define FW_SCRATCH_H

/* The one test of memory lent by a caller: large enough, and aligned for floats. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static inline bool fw_scratch_fits(const void* scratch, size_t given_bytes, size_t needed_bytes) {
    return given_bytes >= needed_bytes && (uintptr_t)scratch % sizeof(float) == 0;
}

#endif
