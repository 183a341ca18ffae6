/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_UART_H
#define FW_UART_H

#include <stddef.h>
#include <stdint.h>

#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Output as TI's mmWave demos send it, so that their visualisers and parsers read it: a header of
 * 40 bytes, then type-length-value blocks (TLV 302, range profile; TLV 1031, class probabilities),
 * then zeros up to a multiple of 32 bytes. A block's length counts its value alone; the packet's
 * length counts everything, the zeros too. All little-endian. */

#define FW_UART_HEADER_BYTES 40
#define FW_UART_TLV_PROFILE 302
#define FW_UART_TLV_CLASSES 1031
#define FW_UART_MAX_BYTES 65536u /* of a packet, written or read: 16372 bins without classes */
#define FW_UART_PLATFORM 0x000A6432u
#define FW_UART_VERSION 0x05030002u /* of the SDK whose format this is: 5.3.0.2 */

/* One packet, before it is written or after it was read. Arrays are borrowed.
 *
 * profile        (n_bins), counts of fw_exported_profile.h; n_bins 0: no block
 * probabilities  (n_classes); n_classes 0: no block
 *                each 0..1, and never -0
 * label          of the most probable class, below n_classes; 0 if there are none */
typedef struct fw_uart_packet {
    uint32_t frame_number, time_cycles;
    const uint32_t* profile;
    uint16_t n_bins;
    const float* probabilities;
    uint16_t n_classes, label;
} fw_uart_packet;

/* Bytes of a packet with so many bins and classes. Time: constant. */
size_t fw_uart_size(uint16_t n_bins, uint16_t n_classes);

/* packet -> out, fw_uart_size bytes: one that fw_uart_read takes back.
 *
 * FW_ERR_NULL     packet or out is NULL, or an array that is not empty
 * FW_ERR_SHAPE    the packet would have more than FW_UART_MAX_BYTES
 * FW_ERR_VALUE    a probability that is NaN, -0 or outside 0..1, or a label that is no class
 * FW_ERR_SCRATCH  out_bytes too small
 * Time: one step per byte. */
fw_status fw_uart_write(const fw_uart_packet* packet, uint8_t out[], size_t out_bytes);

/* Where the parts of a received packet are; values are read with fw_read_u32, fw_read_f32. */
typedef struct fw_uart_view {
    uint32_t frame_number, time_cycles;
    const uint8_t* profile; /* (n_bins) u32, unaligned; NULL if there is none */
    uint32_t n_bins;
    const uint8_t* probabilities; /* (n_classes) f32, unaligned; NULL if there is none */
    uint32_t n_classes, label;
    uint32_t n_tlvs; /* of any type */
} fw_uart_view;

/* The first packet in a stream of bytes, which may begin anywhere. *n_used says how many bytes to
 * drop before the next call, whatever the result (on FW_ERR_NULL it is not written).
 *
 * FW_OK           a packet; view points into bytes
 * FW_ERR_NULL     any pointer is NULL
 * FW_ERR_MAGIC    no packet begins here
 * FW_ERR_LENGTH   a packet begins here but does not end: call again with more bytes
 * FW_ERR_VALUE    a packet whose lengths contradict each other or that is longer than
 *                 FW_UART_MAX_BYTES, with a probability that is NaN, -0 or outside 0..1 or a label
 *                 that is no class; its start is dropped
 * Time: one step per byte. */
fw_status fw_uart_read(const uint8_t bytes[], size_t n_bytes, fw_uart_view* view, size_t* n_used);

#ifdef __cplusplus
}
#endif

#endif
