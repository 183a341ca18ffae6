/* SPDX-License-Identifier: Apache-2.0 */
/* Any bytes as frames of ADC injection: opened or refused, and every frame can be read and put
 * through extraction. */
#include <stdlib.h>
#include <string.h>

#include "firmware/fw_extract.h"
#include "firmware/fw_frame_quality.h"
#include "firmware/fw_injection.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes);

static void use_frame(const fw_frame* frame) {
    static const fw_window windows[3] = {FW_WINDOW_RECT, FW_WINDOW_HANN, FW_WINDOW_BLACKMAN};
    fw_frame_quality quality;
    if (fw_frame_inspect(frame, 12, &quality) != FW_OK) abort();
    const size_t n_scratch = fw_extract_scratch(frame);
    void* const scratch = malloc(n_scratch);
    float out[4];
    for (size_t i = 0; i < 6; ++i) {
        const fw_extract_config config = {1, 4, windows[i % 3], FW_INTEGRATE_EXPORTED,
                                          i < 3 ? FW_RANGE_FLOAT : FW_RANGE_HWA_LIKE};
        (void)fw_extract(frame, &config, scratch, n_scratch, out);
    }
    free(scratch);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes) {
    uint8_t* const bytes = malloc(n_bytes + 1);
    memcpy(bytes, data, n_bytes);
    fw_injection injection;
    if (fw_injection_open(bytes, n_bytes, &injection) == FW_OK) {
        for (uint32_t i = 0; i < injection.n_frames && i < 4; ++i) {
            const fw_frame frame = fw_injection_frame(&injection, injection.n_frames - 1 - i);
            use_frame(&frame);
        }
        if (fw_injection_frame(&injection, injection.n_frames).samples != NULL) abort();
    }
    free(bytes);
    return 0;
}
