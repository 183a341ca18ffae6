/* SPDX-License-Identifier: Apache-2.0 */
/* Any bytes as a stream from the UART: the reader always moves on, and every value of what it finds
 * lies in the stream. */
#include <stdlib.h>
#include <string.h>

#include "firmware/fw_bytes.h"
#include "firmware/fw_uart.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes);

static uint32_t sum_values(const fw_uart_view* view) {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < view->n_bins; ++i) sum += fw_read_u32(view->profile + 4 * i);
    for (uint32_t i = 0; i < view->n_classes; ++i) {
        sum += fw_read_f32(view->probabilities + 4 * i) > 0.5f ? 1 : 0;
    }
    return sum;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes) {
    uint8_t* const bytes = malloc(n_bytes + 1);
    memcpy(bytes, data, n_bytes);
    static volatile uint32_t seen;
    size_t at = 0;
    for (;;) {
        fw_uart_view view;
        size_t n_used = 0;
        const fw_status status = fw_uart_read(bytes + at, n_bytes - at, &view, &n_used);
        if (n_used > n_bytes - at) abort();
        at += n_used;
        if (status == FW_OK) seen += sum_values(&view);
        if (status == FW_ERR_MAGIC || status == FW_ERR_LENGTH) break;
        if (n_used == 0) abort();
    }
    free(bytes);
    return 0;
}
