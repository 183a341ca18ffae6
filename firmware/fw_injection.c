/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_injection.h"

#include <stdbool.h>

#include "fw_bytes.h"

/* Samples are used in place. */
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "injected samples are little-endian");

static bool in_range(uint32_t n_samples, uint32_t n_rx, uint32_t n_chirps) {
    return n_samples >= FW_MIN_SAMPLES && n_samples <= FW_MAX_SAMPLES && n_rx > 0 &&
           n_rx <= UINT16_MAX && n_chirps > 0 && n_chirps <= UINT16_MAX;
}

fw_status fw_injection_read_header(const uint8_t header[], fw_injection* injection) {
    if (header == NULL || injection == NULL) return FW_ERR_NULL;
    const uint32_t n_samples = fw_read_u32(header), n_rx = fw_read_u32(header + 4);
    const uint32_t n_chirps = fw_read_u32(header + 8), n_frames = fw_read_u32(header + 12);
    if (!in_range(n_samples, n_rx, n_chirps) || n_frames == 0) return FW_ERR_SHAPE;
    *injection = (fw_injection){.samples = NULL,
                                .n_samples = (uint16_t)n_samples,
                                .n_rx = (uint16_t)n_rx,
                                .n_chirps = (uint16_t)n_chirps,
                                .n_frames = n_frames};
    return FW_OK;
}

fw_status fw_injection_open(const void* bytes, size_t n_bytes, fw_injection* injection) {
    if (bytes == NULL || injection == NULL) return FW_ERR_NULL;
    if ((uintptr_t)bytes % 4 != 0) return FW_ERR_ALIGNMENT;
    if (n_bytes < FW_INJECTION_HEADER_BYTES) return FW_ERR_LENGTH;
    fw_injection found;
    const fw_status refused = fw_injection_read_header(bytes, &found);
    if (refused != FW_OK) return refused;

    /* 10 + 16 + 16 bits, and one for the two bytes: no product overflows. */
    const uint64_t frame_bytes =
        (uint64_t)found.n_samples * found.n_rx * found.n_chirps * sizeof(int16_t);
    const size_t payload = n_bytes - FW_INJECTION_HEADER_BYTES;
    if (frame_bytes > payload) return FW_ERR_LENGTH;
    const size_t one = (size_t)frame_bytes; /* fits: no 64-bit division, which is no instruction */
    if (payload / one != found.n_frames || payload % one != 0) return FW_ERR_LENGTH;
    found.samples = (const int16_t*)bytes + FW_INJECTION_HEADER_BYTES / sizeof(int16_t);
    *injection = found;
    return FW_OK;
}

fw_frame fw_injection_frame(const fw_injection* injection, uint32_t i) {
    if (injection == NULL || i >= injection->n_frames) return (fw_frame){0};
    const size_t codes = (size_t)injection->n_samples * injection->n_rx * injection->n_chirps;
    return (fw_frame){.samples = injection->samples + i * codes,
                      .n_chirps = injection->n_chirps,
                      .n_rx = injection->n_rx,
                      .n_samples = injection->n_samples};
}
