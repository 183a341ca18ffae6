/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_SELFTEST_H
#define FW_SELFTEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which parts gave the bits they must. The model's own bytes are checked by fw_model_open, the
 * stack by whoever laid a canary at its end. */
typedef struct fw_selftest_report {
    bool checksum;  /* fw_crc32 of its standard test string */
    bool profile;   /* float range profile of the stored chirp */
    bool shape;     /* shape of its peak */
    bool hwa_like;  /* fixed-point transform of the same */
    bool network;   /* logits in float, int16 and int8 */
    bool softmax;   /* probabilities of those logits */
    bool subnormal; /* sums with numbers below FLT_MIN, which some machines flush to zero */
} fw_selftest_report;

/* Bytes of scratch fw_selftest needs. Time: constant. */
size_t fw_selftest_scratch(void);

/* Runs the library on stored inputs and compares every bit with stored results (fw_golden.h), which
 * do not come from this library: for the start of a device, and after a change of compiler.
 *
 * scratch  scratch_bytes >= fw_selftest_scratch(), aligned to 4
 * report   out: written on FW_OK and on FW_ERR_SELF_TEST
 *
 * FW_ERR_NULL       a pointer is NULL
 * FW_ERR_SCRATCH    scratch too small or misaligned
 * FW_ERR_SELF_TEST  a part of the report is false
 * Time: three transforms of 128 samples and four small networks. */
fw_status fw_selftest(void* scratch, size_t scratch_bytes, fw_selftest_report* report);

#ifdef __cplusplus
}
#endif

#endif
