/* SPDX-License-Identifier: Apache-2.0 */
/* Any bytes as a model blob: opened or refused, and what opened runs on any frame. The checksum is
 * put right first, or no input would come further than it. */
#include <stdlib.h>
#include <string.h>

#include "firmware/fw_bytes.h"
#include "firmware/fw_classify.h"
#include "firmware/fw_crc32.h"

#define MAX_BYTES 16384
#define MAX_CODES 65536

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes);

static void run_model(const fw_model* model) {
    static int16_t samples[MAX_CODES];
    const fw_chirp* const chirp = &model->chirp;
    if ((uint64_t)chirp->n_samples * chirp->n_rx * chirp->n_chirps > MAX_CODES) return;
    for (size_t i = 0; i < MAX_CODES; ++i) samples[i] = (int16_t)((i * 2654435761u) >> 16);
    const fw_frame frame = {samples, chirp->n_chirps, chirp->n_rx, chirp->n_samples};
    const size_t n_scratch = fw_classify_scratch(model);
    void* const scratch = malloc(n_scratch); /* exactly as large as asked for */
    fw_result result;
    const fw_status status = fw_classify(model, &frame, scratch, n_scratch, &result);
    if (status == FW_OK && result.label >= model->n_classes) abort();
    if (status != FW_OK && status != FW_ERR_NONFINITE) abort();
    free(scratch);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes) {
    if (n_bytes < 16 || n_bytes > MAX_BYTES) return 0;
    uint8_t* const blob = malloc(n_bytes); /* of this size: what is read behind it is found */
    memcpy(blob, data, n_bytes);
    fw_model model;
    (void)fw_model_open(blob, n_bytes, &model);
    memcpy(blob, "RFWM\0\0\0\0", 8);
    fw_write_u32(blob + 8, (uint32_t)n_bytes);
    fw_write_u32(blob + 12, fw_crc32(blob + 16, n_bytes - 16));
    for (uint16_t version = 1; version <= 2; ++version) { /* each has its own kind of features */
        fw_write_u16(blob + 4, version);
        if (fw_model_open(blob, n_bytes, &model) == FW_OK) run_model(&model);
    }
    free(blob);
    return 0;
}
