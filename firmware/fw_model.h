/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_MODEL_H
#define FW_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fw_extract.h"
#include "fw_frame.h"
#include "fw_int_mlp.h"
#include "fw_mlp.h"
#include "fw_monitor.h"
#include "fw_normalise.h"
#include "fw_relative.h"
#include "fw_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The model blob, versions 1 and 2: everything a trained classifier needs, in one block of bytes
 * that is used where it lies (MODEL_FORMAT.md). */

#define FW_MODEL_MAX_CLASSES 16
#define FW_MODEL_MAX_FEATURES 64
#define FW_MODEL_NAME_BYTES 24 /* a class name and the zeros that fill it up, one at least */

/* What the radar did when the model was trained: its fingerprint. A classifier of range bins is
 * worth nothing under another chirp, so all of it must agree. */
typedef struct fw_chirp {
    uint32_t start_khz;   /* frequency of the ramp's start */
    int32_t slope_khz_us; /* kHz per us; below 0 for a falling ramp */
    uint32_t sample_rate_hz;
    uint16_t n_samples;       /* per chirp */
    uint16_t skip_samples;    /* dropped at the start of the ramp */
    uint16_t n_rx;            /* rows per chirp */
    uint16_t n_chirps;        /* per frame */
    uint16_t high_pass_hz_10; /* corner of the IF high-pass, in units of 10 Hz */
    int16_t gain_db_100;      /* receiver gain, in units of 0.01 dB */
    uint16_t adc_bits;        /* of the converter: codes reach -2^(bits - 1) */
} fw_chirp;

typedef enum fw_arithmetic {
    FW_ARITHMETIC_FLOAT,
    FW_ARITHMETIC_INT16,
    FW_ARITHMETIC_INT8,
} fw_arithmetic;

/* What the numbers are that the network sees. */
typedef enum fw_feature_kind {
    FW_FEATURES_RANGE_BINS, /* amplitudes by fw_extract, then fw_normalise; blobs of version 1 */
    FW_FEATURES_PEAK_SHAPE, /* 2 n_around + 1 numbers by fw_relative; blobs of version 2 */
} fw_feature_kind;

/* An opened blob: counts copied, arrays borrowed. Which of `real` and `whole` is set, `arithmetic`
 * says. With `align` or `compensate_range` the peak is looked for in search_first .. search_first +
 * n_search - 1; without, those are the bins of the descriptor.
 *
 * A peak shape is taken as `shape` says, and nothing is normalised. Its descriptor is the profile in
 * which the peak is looked for, over all rows and by the float transform, for those who show it. */
typedef struct fw_model {
    fw_feature_kind kind;
    fw_arithmetic arithmetic;
    uint16_t n_features, n_classes;
    fw_chirp chirp;
    fw_extract_config descriptor;
    fw_normalise_config normalise;
    uint16_t search_first, n_search;
    fw_relative_config shape; /* all 0 for range bins */
    fw_mlp real;
    fw_int_mlp whole;
    bool has_monitor;
    fw_mahalanobis monitor;
    float suspicious_squared; /* a squared distance above this is suspicious */
    const char* class_name[FW_MODEL_MAX_CLASSES];
} fw_model;

/* Opens a blob of n_bytes, checking all of it: nothing a model that opened holds can make a later
 * function read beyond the blob, overflow an integer or (but for fw_mlp_run's FW_ERR_NONFINITE)
 * fail. The bytes must stay as they are while the model is used.
 *
 * FW_ERR_NULL       a pointer is NULL
 * FW_ERR_ALIGNMENT  blob is not aligned to 4
 * FW_ERR_MAGIC      the bytes do not begin as a model
 * FW_ERR_VERSION    another version than 1 and 2, or not the one that its kind of features asks for
 * FW_ERR_LENGTH     n_bytes is not what the header says, or not what the counts ask for
 * FW_ERR_CHECKSUM   the CRC-32 is wrong
 * FW_ERR_CONFIG     a choice that does not exist, or bins beyond the spectrum
 * FW_ERR_SHAPE      a count out of range
 * FW_ERR_NAME       a class name that is empty, without its end, no UTF-8, followed by anything
 *                   but zeros, or there twice
 * FW_ERR_VALUE      a number that is not finite or, where it must be 0 because nothing uses it, is
 *                   not 0; a negative scale; integers that could overflow
 * Time: two passes over the bytes. */
fw_status fw_model_open(const void* blob, size_t n_bytes, fw_model* model);

/* FW_OK if the radar runs the chirp the model was trained on; else FW_ERR_CHIRP (or FW_ERR_NULL).
 * Time: constant. */
fw_status fw_model_accepts_chirp(const fw_model* model, const fw_chirp* running);

/* FW_OK if a frame has the shape the model was trained on; else FW_ERR_GEOMETRY (or FW_ERR_NULL).
 * Its samples are not read. Time: constant. */
fw_status fw_model_accepts_frame(const fw_model* model, const fw_frame* frame);

#ifdef __cplusplus
}
#endif

#endif
