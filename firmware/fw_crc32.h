/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_CRC32_H
#define FW_CRC32_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* CRC-32 of n bytes: polynomial 0x04C11DB7 reflected, initial value and final XOR all ones, as in
 * ISO 3309, zlib and Ethernet; "123456789" gives 0xCBF43926. Of no bytes, or of bytes = NULL, 0.
 * Time: two table steps per byte. */
uint32_t fw_crc32(const uint8_t bytes[], size_t n);

#ifdef __cplusplus
}
#endif

#endif
