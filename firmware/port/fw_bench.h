/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_BENCH_H
#define FW_BENCH_H

#include <stddef.h>
#include <stdint.h>

#include "../fw_frame.h"
#include "../fw_model.h"
#include "../fw_status.h"

/* What is timed: an opened model, its bytes, and one frame of its shape. */
typedef struct fw_bench {
    const fw_model* model;
    const void* blob;
    size_t blob_bytes;
    const fw_frame* frame;
    void* scratch;
    size_t scratch_bytes;
    uint32_t repeats;
} fw_bench;

/* Runs every stage `repeats` times and prints a line for each, "stage NAME TICKS"; the first,
 * "empty", is the loop itself. Before and after every single run stands a call of fw_bench_mark, so
 * that a trace of the processor can be parted too. Returns the first status that is not FW_OK. */
fw_status fw_bench_run(const fw_bench* bench);

void fw_bench_mark(void);

#endif
