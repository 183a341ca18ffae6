/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_uart.h"

#include <stdbool.h>

#include "fw_bytes.h"

#define TLV_BYTES 8
#define CLASS_COUNTS_BYTES 8 /* label and number of classes, before the probabilities */
#define MULTIPLE 32
#define BITS_OF_ONE 0x3F800000u
#define NO_SUBFRAME 0xFFFFFFFFu

static const uint8_t magic[8] = {2, 1, 4, 3, 6, 5, 8, 7};

static size_t unpadded_size(uint16_t n_bins, uint16_t n_classes) {
    size_t n = FW_UART_HEADER_BYTES;
    if (n_bins > 0) n += TLV_BYTES + 4 * (size_t)n_bins;
    if (n_classes > 0) n += TLV_BYTES + CLASS_COUNTS_BYTES + 4 * (size_t)n_classes;
    return n;
}

size_t fw_uart_size(uint16_t n_bins, uint16_t n_classes) {
    return (unpadded_size(n_bins, n_classes) + MULTIPLE - 1) / MULTIPLE * MULTIPLE;
}

static void write_header(const fw_uart_packet* packet, uint32_t n_bytes, uint8_t out[]) {
    const uint32_t n_tlvs = (packet->n_bins > 0 ? 1u : 0u) + (packet->n_classes > 0 ? 1u : 0u);
    memcpy(out, magic, sizeof magic);
    fw_write_u32(out + 8, FW_UART_VERSION);
    fw_write_u32(out + 12, n_bytes);
    fw_write_u32(out + 16, FW_UART_PLATFORM);
    fw_write_u32(out + 20, packet->frame_number);
    fw_write_u32(out + 24, packet->time_cycles);
    fw_write_u32(out + 28, 0); /* detected objects */
    fw_write_u32(out + 32, n_tlvs);
    fw_write_u32(out + 36, NO_SUBFRAME);
}

/* Returns the place behind the head. */
static uint8_t* write_tlv_head(uint8_t* place, uint32_t type, uint32_t value_bytes) {
    fw_write_u32(place, type);
    fw_write_u32(place + 4, value_bytes);
    return place + TLV_BYTES;
}

static uint8_t* write_profile(const fw_uart_packet* packet, uint8_t* place) {
    if (packet->n_bins == 0) return place;
    place = write_tlv_head(place, FW_UART_TLV_PROFILE, 4u * packet->n_bins);
    for (size_t k = 0; k < packet->n_bins; ++k, place += 4) {
        fw_write_u32(place, packet->profile[k]);
    }
    return place;
}

static uint8_t* write_classes(const fw_uart_packet* packet, uint8_t* place) {
    if (packet->n_classes == 0) return place;
    place = write_tlv_head(place, FW_UART_TLV_CLASSES, CLASS_COUNTS_BYTES + 4u * packet->n_classes);
    fw_write_u32(place, packet->label);
    fw_write_u32(place + 4, packet->n_classes);
    place += CLASS_COUNTS_BYTES;
    for (size_t c = 0; c < packet->n_classes; ++c, place += 4) {
        fw_write_f32(place, packet->probabilities[c]);
    }
    return place;
}

/* Of positive floats the larger has the larger bits, and NaN and all below 0 have larger ones than
 * any: one comparison of whole numbers says whether a float is in 0..1. */
static bool is_probability(uint32_t bits) {
    return bits <= BITS_OF_ONE;
}

static bool answers_are_sound(const fw_uart_packet* packet) {
    for (size_t c = 0; c < packet->n_classes; ++c) {
        uint32_t bits;
        memcpy(&bits, &packet->probabilities[c], sizeof bits);
        if (!is_probability(bits)) return false;
    }
    return packet->label == 0 || packet->label < packet->n_classes;
}

fw_status fw_uart_write(const fw_uart_packet* packet, uint8_t out[], size_t out_bytes) {
    if (packet == NULL || out == NULL) return FW_ERR_NULL;
    if (packet->n_bins > 0 && packet->profile == NULL) return FW_ERR_NULL;
    if (packet->n_classes > 0 && packet->probabilities == NULL) return FW_ERR_NULL;
    const size_t n_bytes = fw_uart_size(packet->n_bins, packet->n_classes);
    if (n_bytes > FW_UART_MAX_BYTES) return FW_ERR_SHAPE;
    if (!answers_are_sound(packet)) return FW_ERR_VALUE;
    if (out_bytes < n_bytes) return FW_ERR_SCRATCH;
    write_header(packet, (uint32_t)n_bytes, out);
    uint8_t* place = write_profile(packet, out + FW_UART_HEADER_BYTES);
    place = write_classes(packet, place);
    for (; place < out + n_bytes; place += 4) fw_write_u32(place, 0); /* all counts are of words */
    return FW_OK;
}

/* Bytes before the first possible start of a packet: a whole magic word, or its beginning at the
 * end of the bytes. */
static size_t find_start(const uint8_t bytes[], size_t n_bytes) {
    for (size_t i = 0; i < n_bytes; ++i) {
        const size_t n = n_bytes - i < sizeof magic ? n_bytes - i : sizeof magic;
        if (memcmp(bytes + i, magic, n) == 0) return i;
    }
    return n_bytes;
}

/* Takes one block of n_bytes of value into the view; false if its counts do not fit or its values
 * are none. */
static bool read_tlv(uint32_t type, const uint8_t* value, uint32_t n_bytes, fw_uart_view* view) {
    if (type == FW_UART_TLV_PROFILE) {
        view->profile = value;
        view->n_bins = n_bytes / 4;
        return n_bytes % 4 == 0;
    }
    if (type == FW_UART_TLV_CLASSES) {
        if (n_bytes < CLASS_COUNTS_BYTES) return false;
        view->label = fw_read_u32(value);
        view->n_classes = fw_read_u32(value + 4);
        view->probabilities = value + CLASS_COUNTS_BYTES;
        if (view->n_classes != (n_bytes - CLASS_COUNTS_BYTES) / 4 || n_bytes % 4 != 0) return false;
        for (size_t c = 0; c < view->n_classes; ++c) {
            if (!is_probability(fw_read_u32(view->probabilities + 4 * c))) return false;
        }
        return view->label < view->n_classes;
    }
    return true;
}

static bool read_tlvs(const uint8_t packet[], size_t n_bytes, fw_uart_view* view) {
    size_t at = FW_UART_HEADER_BYTES;
    for (uint32_t i = 0; i < view->n_tlvs; ++i) { /* each takes 8 bytes at least: bounded */
        if (n_bytes - at < TLV_BYTES) return false;
        const uint32_t type = fw_read_u32(packet + at);
        const uint32_t value_bytes = fw_read_u32(packet + at + 4);
        at += TLV_BYTES;
        if (value_bytes > n_bytes - at) return false;
        if (!read_tlv(type, packet + at, value_bytes, view)) return false;
        at += value_bytes;
    }
    return true;
}

fw_status fw_uart_read(const uint8_t bytes[], size_t n_bytes, fw_uart_view* view, size_t* n_used) {
    if (bytes == NULL || view == NULL || n_used == NULL) return FW_ERR_NULL;
    const size_t start = find_start(bytes, n_bytes);
    const uint8_t* const packet = bytes + start;
    const size_t n_left = n_bytes - start;
    *n_used = start;
    if (n_left == 0) return FW_ERR_MAGIC;
    if (n_left < FW_UART_HEADER_BYTES) return FW_ERR_LENGTH;
    const uint32_t packet_bytes = fw_read_u32(packet + 12);
    if (packet_bytes < FW_UART_HEADER_BYTES || packet_bytes > FW_UART_MAX_BYTES) {
        *n_used = start + 1;
        return FW_ERR_VALUE;
    }
    if (n_left < packet_bytes) return FW_ERR_LENGTH;

    fw_uart_view found = {.frame_number = fw_read_u32(packet + 20),
                          .time_cycles = fw_read_u32(packet + 24),
                          .n_tlvs = fw_read_u32(packet + 32)};
    if (!read_tlvs(packet, packet_bytes, &found)) {
        *n_used = start + 1;
        return FW_ERR_VALUE;
    }
    *n_used = start + packet_bytes;
    *view = found;
    return FW_OK;
}
