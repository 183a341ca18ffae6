/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_INJECTION_H
#define FW_INJECTION_H

#include <stddef.h>
#include <stdint.h>

#include "fw_frame.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ADC samples in the layout TI's demo reads back in place of its converter (adcDataSource 1):
 * four little-endian u32 {samples per chirp, virtual antennas, chirps per frame, frames}, then
 * int16 (frame, chirp, virtual antenna, sample). */

#define FW_INJECTION_HEADER_BYTES 16

/* An opened file of samples; borrows its bytes. */
typedef struct fw_injection {
    const int16_t* samples; /* (frame, chirp, antenna, sample) */
    uint16_t n_samples, n_rx, n_chirps;
    uint32_t n_frames;
} fw_injection;

/* The counts of a header alone, FW_INJECTION_HEADER_BYTES bytes at any place, for those who read
 * frames one by one; samples becomes NULL.
 *
 * FW_ERR_NULL   a pointer is NULL
 * FW_ERR_SHAPE  a count out of the range of fw_frame, or no frame
 * Time: constant. */
fw_status fw_injection_read_header(const uint8_t header[], fw_injection* injection);

/* Opens n_bytes, which stay as they are while frames are used.
 *
 * FW_ERR_NULL       a pointer is NULL
 * FW_ERR_ALIGNMENT  bytes are not aligned to 4
 * FW_ERR_SHAPE      a count out of the range of fw_frame, or no frame
 * FW_ERR_LENGTH     n_bytes is not what the counts ask for
 * Time: constant. */
fw_status fw_injection_open(const void* bytes, size_t n_bytes, fw_injection* injection);

/* Frame number i, 0..n_frames - 1; one with samples = NULL otherwise. Time: constant. */
fw_frame fw_injection_frame(const fw_injection* injection, uint32_t i);

#ifdef __cplusplus
}
#endif

#endif
