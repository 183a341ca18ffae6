/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_selftest.h"

#include <string.h>

#include "fw_crc32.h"
#include "fw_golden.h"
#include "fw_hwa_fft.h"
#include "fw_int_mlp.h"
#include "fw_mlp.h"
#include "fw_range_profile.h"
#include "fw_relative.h"
#include "fw_scratch.h"
#include "fw_softmax.h"
#include "fw_strict_float.h"

#define FIRST_BIN 6
#define N_IN FW_GOLDEN_N_IN
#define N_HIDDEN FW_GOLDEN_N_HIDDEN
#define N_OUT FW_GOLDEN_N_OUT
#define INT8_STRIDE 8 /* of the second layer, its rows padded */
#define MEAN 4.0f
#define SCALE 0.0625f
#define LOGIT_SCALE 0x1p-10f
#define WEIGHT_SCALE 0x1p-9f

static bool same_bits(const float values[], const uint32_t expected[], size_t n) {
    return memcmp(values, expected, n * sizeof(float)) == 0;
}

static bool check_profile(void* scratch, size_t scratch_bytes) {
    float features[N_IN];
    const fw_range_config config = {.n_samples = FW_GOLDEN_N_SAMPLES,
                                    .first_bin = FIRST_BIN,
                                    .n_bins = N_IN,
                                    .window = FW_WINDOW_BLACKMAN};
    return fw_range_profile(fw_golden_chirp, &config, scratch, scratch_bytes, features) == FW_OK &&
           same_bits(features, fw_golden_profile, N_IN);
}

static const fw_frame golden_frame = {
    .samples = fw_golden_chirp, .n_chirps = 1, .n_rx = 1, .n_samples = FW_GOLDEN_N_SAMPLES};

static bool check_shape(void* scratch, size_t scratch_bytes) {
    float shape[FW_GOLDEN_N_SHAPE];
    const fw_relative_config config = {.search_first = 4,
                                       .n_search = 20,
                                       .n_around = FW_GOLDEN_N_AROUND,
                                       .window = FW_WINDOW_BLACKMAN,
                                       .target_bin = 11.5f,
                                       .floor_lsb = 0.01f};
    return fw_relative(&golden_frame, &config, scratch, scratch_bytes, shape) == FW_OK &&
           same_bits(shape, fw_golden_shape, FW_GOLDEN_N_SHAPE);
}

static bool check_hwa_like(void* scratch, size_t scratch_bytes) {
    const fw_hwa_config config = {.n_samples = FW_GOLDEN_N_SAMPLES,
                                  .window = FW_WINDOW_BLACKMAN,
                                  .scaled_stages = FW_HWA_DEFAULT_SCALED_STAGES,
                                  .output_shift = FW_HWA_DEFAULT_OUTPUT_SHIFT};
    int16_t* const im_re = scratch;
    return fw_hwa_fft(fw_golden_chirp, &config, scratch, scratch_bytes, im_re, NULL) == FW_OK &&
           memcmp(im_re + 2 * FIRST_BIN, fw_golden_im_re, sizeof fw_golden_im_re) == 0;
}

/* (features - 4) / 16, and the integer networks' rows all alike: see fw_golden.h. */
#define ALIKE(x) x, x, x, x, x, x
static const float mean[N_IN] = {ALIKE(MEAN), ALIKE(MEAN)};
static const float scale[N_IN] = {ALIKE(SCALE), ALIKE(SCALE)};
static const int32_t shift[N_HIDDEN] = {ALIKE(FW_GOLDEN_SHIFT)};
static const float logit_scale[N_OUT + 1] = {ALIKE(LOGIT_SCALE)};

/* What the networks are made of, in the caller's scratch: on the stack it would be the deepest of
 * the library. */
typedef struct real_room {
    float weight[FW_GOLDEN_N_WEIGHTS], bias[N_HIDDEN + N_OUT];
    float features[N_IN], logits[N_OUT], values[2 * N_IN];
} real_room;

typedef struct whole_room {
    int16_t weight[FW_GOLDEN_N_WEIGHT_0 + N_OUT * INT8_STRIDE];
    float features[N_IN], logits[N_OUT];
    int16_t values[2 * N_IN];
} whole_room;

_Static_assert(N_IN % 4 == 0 && N_HIDDEN <= INT8_STRIDE, "rows must fit with their padding");
_Static_assert(FW_GOLDEN_N_WEIGHT_0 % 4 == 0, "the second layer must be aligned to 4");

/* Networks and softmax run on what should come before them: one fault is not told twice. */
static bool check_real(real_room* room) {
    memcpy(room->features, fw_golden_profile, sizeof room->features);
    for (size_t i = 0; i < FW_GOLDEN_N_WEIGHTS; ++i) {
        room->weight[i] = WEIGHT_SCALE * (float)fw_golden_weight[i];
    }
    for (size_t i = 0; i < N_HIDDEN + N_OUT; ++i) {
        room->bias[i] = WEIGHT_SCALE * (float)fw_golden_bias[i];
    }
    const fw_mlp mlp = {
        .n_layers = 2,
        .input_mean = mean,
        .input_scale = scale,
        .layer = {{N_IN, N_HIDDEN, room->weight, room->bias},
                  {N_HIDDEN, N_OUT, room->weight + FW_GOLDEN_N_WEIGHT_0, room->bias + N_HIDDEN}}};
    return fw_mlp_run(&mlp, room->features, room->values, sizeof room->values, room->logits,
                      NULL) == FW_OK &&
           same_bits(room->logits, fw_golden_logits, N_OUT);
}

/* Writes the rows of both layers one behind the other, with the padding of that width. */
static void pad_rows(fw_int_width width, int16_t room[]) {
    const int8_t* weight = fw_golden_weight;
    size_t at = 0;
    for (size_t row = 0; row < N_HIDDEN + N_OUT; ++row) {
        const size_t n_in = row < N_HIDDEN ? N_IN : N_HIDDEN;
        const size_t stride = fw_int_stride(width, (uint16_t)n_in);
        for (size_t i = 0; i < stride; ++i, ++at) {
            const int8_t value = i < n_in ? *weight++ : 0;
            if (width == FW_INT8) {
                ((int8_t*)room)[at] = value;
            } else {
                room[at] = value;
            }
        }
    }
}

static bool check_whole(whole_room* room, fw_int_width width, const uint32_t expected[]) {
    memcpy(room->features, fw_golden_profile, sizeof room->features);
    pad_rows(width, room->weight);
    const size_t width_bytes = width == FW_INT8 ? sizeof(int8_t) : sizeof(int16_t);
    const void* const weight_1 = (const int8_t*)room->weight + FW_GOLDEN_N_WEIGHT_0 * width_bytes;
    const fw_int_mlp mlp = {
        .width = width,
        .n_layers = 2,
        .input_mean = mean,
        .input_scale = scale,
        .input_levels = FW_GOLDEN_INPUT_LEVELS,
        .layer = {{N_IN, N_HIDDEN, room->weight, fw_golden_bias, fw_golden_multiplier, shift, NULL},
                  {N_HIDDEN, N_OUT, weight_1, fw_golden_bias + N_HIDDEN, NULL, NULL, logit_scale}}};
    return fw_int_mlp_run(&mlp, room->features, room->values, sizeof room->values, room->logits,
                          NULL) == FW_OK &&
           same_bits(room->logits, expected, N_OUT);
}

static bool check_softmax(float logits[N_OUT]) {
    memcpy(logits, fw_golden_logits, sizeof fw_golden_logits);
    return fw_softmax(logits, N_OUT, logits) == FW_OK &&
           same_bits(logits, fw_golden_probabilities, N_OUT);
}

/* One layer, whose sums pass below FLT_MIN and end there or above. */
static bool check_subnormal(real_room* room) {
    memcpy(room->weight, fw_golden_subnormal_weight, sizeof fw_golden_subnormal_weight);
    memcpy(room->features, fw_golden_subnormal_in, sizeof fw_golden_subnormal_in);
    memset(room->bias, 0, sizeof room->bias);
    const fw_mlp mlp = {
        .n_layers = 1,
        .layer = {{FW_GOLDEN_N_SUBNORMAL, FW_GOLDEN_N_SUBNORMAL, room->weight, room->bias}}};
    return fw_mlp_run(&mlp, room->features, room->values, sizeof room->values, room->logits,
                      NULL) == FW_OK &&
           same_bits(room->logits, fw_golden_subnormal_logits, FW_GOLDEN_N_SUBNORMAL);
}

static size_t larger(size_t a, size_t b) {
    return a > b ? a : b;
}

size_t fw_selftest_scratch(void) {
    return larger(larger(fw_hwa_fft_scratch(FW_GOLDEN_N_SAMPLES),
                         fw_relative_scratch(&golden_frame)),
                  larger(sizeof(real_room), sizeof(whole_room)));
}

fw_status fw_selftest(void* scratch, size_t scratch_bytes, fw_selftest_report* report) {
    if (scratch == NULL || report == NULL) return FW_ERR_NULL;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_selftest_scratch())) return FW_ERR_SCRATCH;
    static const uint8_t digits[9] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    fw_selftest_report found = {.checksum = fw_crc32(digits, sizeof digits) == 0xCBF43926u};
    found.profile = check_profile(scratch, scratch_bytes);
    found.shape = check_shape(scratch, scratch_bytes);
    found.hwa_like = check_hwa_like(scratch, scratch_bytes);
    found.network = check_real(scratch);
    found.network = check_whole(scratch, FW_INT16, fw_golden_logits_int16) && found.network;
    found.network = check_whole(scratch, FW_INT8, fw_golden_logits_int8) && found.network;
    found.softmax = check_softmax(scratch);
    found.subnormal = check_subnormal(scratch);

    *report = found;
    const bool all = found.checksum && found.profile && found.shape && found.hwa_like &&
                     found.network && found.softmax && found.subnormal;
    return all ? FW_OK : FW_ERR_SELF_TEST;
}
