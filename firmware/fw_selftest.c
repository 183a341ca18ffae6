/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_selftest.h"

#include <string.h>

#include "fw_crc32.h"
#include "fw_golden.h"
#include "fw_hwa_fft.h"
#include "fw_int_mlp.h"
#include "fw_mlp.h"
#include "fw_range_profile.h"
#include "fw_scratch.h"
#include "fw_softmax.h"
#include "fw_strict_float.h"

#define FIRST_BIN 6
#define N_IN FW_GOLDEN_N_IN
#define N_HIDDEN FW_GOLDEN_N_HIDDEN
#define N_OUT FW_GOLDEN_N_OUT
#define MEAN 4.0f
#define SCALE 0.0625f
#define LOGIT_SCALE 0x1p-10f
#define WEIGHT_SCALE 0x1p-9f

static bool same_bits(const float values[], const uint32_t expected[], size_t n) {
    return memcmp(values, expected, n * sizeof(float)) == 0;
}

static bool check_profile(void* scratch, size_t scratch_bytes, float features[N_IN]) {
    const fw_range_config config = {.n_samples = FW_GOLDEN_N_SAMPLES,
                                    .first_bin = FIRST_BIN,
                                    .n_bins = N_IN,
                                    .window = FW_WINDOW_BLACKMAN};
    return fw_range_profile(fw_golden_chirp, &config, scratch, scratch_bytes, features) == FW_OK &&
           same_bits(features, fw_golden_profile, N_IN);
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

/* What both kinds of network share. */
typedef struct small_network {
    float mean[N_IN], scale[N_IN];
    const float* features;
    void* scratch;
    size_t scratch_bytes;
} small_network;

static bool check_real(const small_network* net, float logits[N_OUT]) {
    float weight_0[N_HIDDEN * N_IN], weight_1[N_OUT * N_HIDDEN], bias_0[N_HIDDEN], bias_1[N_OUT];
    for (size_t i = 0; i < N_HIDDEN * N_IN; ++i) {
        weight_0[i] = WEIGHT_SCALE * (float)fw_golden_weight_0[i];
    }
    for (size_t i = 0; i < N_OUT * N_HIDDEN; ++i) {
        weight_1[i] = WEIGHT_SCALE * (float)fw_golden_weight_1[i];
    }
    for (size_t i = 0; i < N_HIDDEN; ++i) bias_0[i] = WEIGHT_SCALE * (float)fw_golden_bias_0[i];
    for (size_t i = 0; i < N_OUT; ++i) bias_1[i] = WEIGHT_SCALE * (float)fw_golden_bias_1[i];
    const fw_mlp mlp = {
        .n_layers = 2,
        .input_mean = net->mean,
        .input_scale = net->scale,
        .layer = {{N_IN, N_HIDDEN, weight_0, bias_0}, {N_HIDDEN, N_OUT, weight_1, bias_1}}};
    return fw_mlp_run(&mlp, net->features, net->scratch, net->scratch_bytes, logits, NULL) ==
               FW_OK &&
           same_bits(logits, fw_golden_logits, N_OUT);
}

/* Writes a weight row by row, with the padding of that width; returns where. */
static const void* pad_rows(const int8_t weight[], size_t n_out, size_t n_in, fw_int_width width,
                            int16_t room[]) {
    const size_t stride = fw_int_stride(width, (uint16_t)n_in);
    int8_t* const bytes = (int8_t*)room;
    for (size_t o = 0; o < n_out; ++o) {
        for (size_t i = 0; i < stride; ++i) {
            const int8_t value = i < n_in ? weight[o * n_in + i] : 0;
            if (width == FW_INT8) bytes[o * stride + i] = value;
            if (width == FW_INT16) room[o * stride + i] = value;
        }
    }
    return room;
}

static bool check_whole(const small_network* net, fw_int_width width, const uint32_t expected[]) {
    _Alignas(4) int16_t room_0[N_HIDDEN * N_IN];
    _Alignas(4) int16_t room_1[N_OUT * 8];
    int32_t multiplier[N_HIDDEN], shift[N_HIDDEN];
    float scale[N_OUT], logits[N_OUT];
    for (size_t o = 0; o < N_HIDDEN; ++o) multiplier[o] = fw_golden_multiplier;
    for (size_t o = 0; o < N_HIDDEN; ++o) shift[o] = FW_GOLDEN_SHIFT;
    for (size_t o = 0; o < N_OUT; ++o) scale[o] = LOGIT_SCALE;
    const fw_int_mlp mlp = {
        .width = width,
        .n_layers = 2,
        .input_mean = net->mean,
        .input_scale = net->scale,
        .input_levels = FW_GOLDEN_INPUT_LEVELS,
        .layer = {{N_IN, N_HIDDEN, pad_rows(fw_golden_weight_0, N_HIDDEN, N_IN, width, room_0),
                   fw_golden_bias_0, multiplier, shift, NULL},
                  {N_HIDDEN, N_OUT, pad_rows(fw_golden_weight_1, N_OUT, N_HIDDEN, width, room_1),
                   fw_golden_bias_1, NULL, NULL, scale}}};
    return fw_int_mlp_run(&mlp, net->features, net->scratch, net->scratch_bytes, logits, NULL) ==
               FW_OK &&
           same_bits(logits, expected, N_OUT);
}

size_t fw_selftest_scratch(void) {
    return fw_hwa_fft_scratch(FW_GOLDEN_N_SAMPLES);
}

fw_status fw_selftest(void* scratch, size_t scratch_bytes, fw_selftest_report* report) {
    if (scratch == NULL || report == NULL) return FW_ERR_NULL;
    if (!fw_scratch_fits(scratch, scratch_bytes, fw_selftest_scratch())) return FW_ERR_SCRATCH;
    static const uint8_t digits[9] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    float features[N_IN], logits[N_OUT], probabilities[N_OUT];
    fw_selftest_report found = {.checksum = fw_crc32(digits, sizeof digits) == 0xCBF43926u};
    found.profile = check_profile(scratch, scratch_bytes, features);
    found.hwa_like = check_hwa_like(scratch, scratch_bytes);

    /* The networks run on what the profile should be: one fault is not told twice. */
    small_network net = {.scratch = scratch, .scratch_bytes = scratch_bytes};
    memcpy(features, fw_golden_profile, sizeof features);
    net.features = features;
    for (size_t i = 0; i < N_IN; ++i) net.mean[i] = MEAN;
    for (size_t i = 0; i < N_IN; ++i) net.scale[i] = SCALE;
    found.network = check_real(&net, logits);
    found.network = check_whole(&net, FW_INT16, fw_golden_logits_int16) && found.network;
    found.network = check_whole(&net, FW_INT8, fw_golden_logits_int8) && found.network;
    memcpy(logits, fw_golden_logits, sizeof logits);
    found.softmax = fw_softmax(logits, N_OUT, probabilities) == FW_OK &&
                    same_bits(probabilities, fw_golden_probabilities, N_OUT);

    *report = found;
    const bool all =
        found.checksum && found.profile && found.hwa_like && found.network && found.softmax;
    return all ? FW_OK : FW_ERR_SELF_TEST;
}
