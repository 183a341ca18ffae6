/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_MODEL_ARRAYS_H
#define FW_MODEL_ARRAYS_H

/* The second half of fw_model_open: what follows the fixed part of a blob. */

#include <stddef.h>
#include <stdint.h>

#include "fw_model.h"

/* Outputs of each layer; those from n_layers on are 0. */
typedef struct fw_model_widths {
    uint16_t n_layers;
    uint16_t n_out[FW_MLP_MAX_LAYERS];
} fw_model_widths;

/* Bytes not read yet; next is aligned to 4. */
typedef struct fw_blob_rest {
    const uint8_t* next;
    size_t n_left;
} fw_blob_rest;

/* Class names, standardisation, layers and monitor of a model whose counts are read.
 * FW_ERR_SHAPE, FW_ERR_LENGTH, FW_ERR_NAME, FW_ERR_VALUE as in fw_model_open.
 * Time: one step per byte, and one comparison per pair of class names. */
fw_status fw_model_read_arrays(fw_blob_rest* rest, const fw_model_widths* widths, fw_model* model);

#endif
