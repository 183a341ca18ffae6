/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_BYTES_H
#define FW_BYTES_H

/* Numbers in little-endian bytes, wherever they lie and whatever the machine's own order. */

#include <stdint.h>
#include <string.h>

static inline uint16_t fw_read_u16(const uint8_t* place) {
    return (uint16_t)(place[0] | place[1] << 8);
}

static inline uint32_t fw_read_u32(const uint8_t* place) {
    return (uint32_t)fw_read_u16(place) | (uint32_t)fw_read_u16(place + 2) << 16;
}

static inline float fw_read_f32(const uint8_t* place) {
    const uint32_t bits = fw_read_u32(place);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void fw_write_u16(uint8_t* place, uint16_t value) {
    place[0] = (uint8_t)(value & 0xFFu);
    place[1] = (uint8_t)(value >> 8);
}

static inline void fw_write_u32(uint8_t* place, uint32_t value) {
    fw_write_u16(place, (uint16_t)(value & 0xFFFFu));
    fw_write_u16(place + 2, (uint16_t)(value >> 16));
}

static inline void fw_write_f32(uint8_t* place, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    fw_write_u32(place, bits);
}

#endif
