/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_crc32.h"

#define POLYNOMIAL 0xEDB88320u /* reflected */
#define STEP(x) ((x)&1u ? (x) >> 1 ^ POLYNOMIAL : (x) >> 1)
#define ENTRY(i) STEP(STEP(STEP(STEP((uint32_t)(i)))))

/* Half a byte at a time: 64 bytes of table instead of 1024, made by the compiler. */
static const uint32_t table[16] = {
    ENTRY(0), ENTRY(1), ENTRY(2),  ENTRY(3),  ENTRY(4),  ENTRY(5),  ENTRY(6),  ENTRY(7),
    ENTRY(8), ENTRY(9), ENTRY(10), ENTRY(11), ENTRY(12), ENTRY(13), ENTRY(14), ENTRY(15),
};

uint32_t fw_crc32(const uint8_t bytes[], size_t n) {
    if (bytes == NULL) return 0;
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < n; ++i) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return ~crc;
}
