/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_model.h"

#include "fw_bytes.h"
#include "fw_crc32.h"
#include "fw_model_arrays.h"
#include "fw_range_profile.h"
#include "fw_strict_float.h"

/* Arrays of the blob are used in place. */
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "models are little-endian");

#define VERSION_RANGE_BINS 1
#define VERSION_PEAK_SHAPE 2
#define START_BYTES 16 /* magic, version, reserved, length, CRC */
#define FACTS_BYTES 84
#define MIN_BYTES (START_BYTES + FACTS_BYTES)
#define MAX_ADC_BITS 16

static const uint8_t magic[4] = {'R', 'F', 'W', 'M'};

static fw_status check_start(const uint8_t* bytes, size_t n_bytes) {
    if ((uintptr_t)bytes % sizeof(float) != 0) return FW_ERR_ALIGNMENT;
    if (n_bytes < sizeof magic || memcmp(bytes, magic, sizeof magic) != 0) return FW_ERR_MAGIC;
    if (n_bytes < MIN_BYTES) return FW_ERR_LENGTH;
    const uint16_t version = fw_read_u16(bytes + 4);
    const bool is_known = version == VERSION_RANGE_BINS || version == VERSION_PEAK_SHAPE;
    if (!is_known || fw_read_u16(bytes + 6) != 0) return FW_ERR_VERSION;
    if (fw_read_u32(bytes + 8) != n_bytes) return FW_ERR_LENGTH;
    const uint32_t crc = fw_crc32(bytes + START_BYTES, n_bytes - START_BYTES);
    return fw_read_u32(bytes + 12) == crc ? FW_OK : FW_ERR_CHECKSUM;
}

static void read_chirp(const uint8_t* facts, fw_chirp* chirp) {
    *chirp = (fw_chirp){.start_khz = fw_read_u32(facts),
                        .slope_khz_us = (int32_t)fw_read_u32(facts + 4),
                        .sample_rate_hz = fw_read_u32(facts + 8),
                        .n_samples = fw_read_u16(facts + 12),
                        .skip_samples = fw_read_u16(facts + 14),
                        .n_rx = fw_read_u16(facts + 16),
                        .n_chirps = fw_read_u16(facts + 18),
                        .high_pass_hz_10 = fw_read_u16(facts + 20),
                        .gain_db_100 = (int16_t)fw_read_u16(facts + 22),
                        .adc_bits = fw_read_u16(facts + 24)};
}

static bool chirp_in_range(const fw_chirp* chirp) {
    return fw_range_fft_size(chirp->n_samples) != 0 && chirp->n_rx > 0 && chirp->n_chirps > 0 &&
           chirp->adc_bits >= 2 && chirp->adc_bits <= MAX_ADC_BITS;
}

static bool bins_fit(const fw_model* model) {
    const uint32_t n_spectrum = fw_range_fft_size(model->chirp.n_samples) / 2u;
    const uint32_t first = model->descriptor.first_bin, last = first + model->descriptor.n_bins;
    const uint32_t search_last = (uint32_t)model->search_first + model->n_search;
    const bool uses_peak = model->normalise.align || model->normalise.compensate_range;
    const bool same = model->search_first == first && search_last == last;
    return model->descriptor.n_bins > 0 && model->search_first <= first && last <= search_last &&
           search_last <= n_spectrum && (uses_peak || same);
}

/* A blob has one form: what version 1 can say is said in version 1, whose field of the kind was
 * reserved. */
static fw_status check_kind(uint16_t version, uint16_t kind) {
    if (version == VERSION_RANGE_BINS) return kind == 0 ? FW_OK : FW_ERR_CONFIG;
    if (kind == FW_FEATURES_RANGE_BINS) return FW_ERR_VERSION;
    return kind == FW_FEATURES_PEAK_SHAPE ? FW_OK : FW_ERR_CONFIG;
}

/* Amplitudes of bins that exist, and no number that nothing uses. */
static fw_status check_range_bins(const fw_model* model, const uint8_t* facts) {
    if (!fw_normalise_valid(&model->normalise) || !bins_fit(model)) return FW_ERR_CONFIG;
    const bool uses_peak = model->normalise.align || model->normalise.compensate_range;
    if (!uses_peak && fw_read_u32(facts + 24) != 0) return FW_ERR_VALUE; /* unused, so zero bits */
    if (!model->normalise.logarithm && fw_read_u32(facts + 28) != 0) return FW_ERR_VALUE;
    return FW_OK;
}

static fw_status check_peak_shape(const fw_model* model, const uint8_t* facts) {
    if (fw_read_u16(facts + 12) != 0 || fw_read_u16(facts + 22) != 0) return FW_ERR_CONFIG;
    if (model->descriptor.integration != FW_INTEGRATE_MEAN) return FW_ERR_CONFIG;
    if (model->descriptor.path != FW_RANGE_FLOAT) return FW_ERR_CONFIG;
    const fw_frame frame = {.samples = NULL,
                            .n_chirps = model->chirp.n_chirps,
                            .n_rx = model->chirp.n_rx,
                            .n_samples = model->chirp.n_samples};
    return fw_relative_check(&frame, &model->shape);
}

/* Choices that exist, of bins that exist; enumerations are compared as the numbers they came as. */
static fw_status check_choices(const fw_model* model, const uint8_t* facts) {
    if (fw_read_u16(facts) > FW_ARITHMETIC_INT8) return FW_ERR_CONFIG;
    if (fw_read_u16(facts + 2) > 1) return FW_ERR_CONFIG; /* flags: 1, a monitor */
    if (fw_read_u16(facts + 18) > FW_INTEGRATE_EXPORTED) return FW_ERR_CONFIG;
    if (fw_read_u16(facts + 20) > FW_RANGE_HWA_LIKE) return FW_ERR_CONFIG;
    if (fw_read_u16(facts + 22) > 7) return FW_ERR_CONFIG; /* align, compensate, logarithm */
    if (fw_read_u16(facts + 70) != 0 || fw_read_u32(facts + 80) != 0) return FW_ERR_CONFIG;
    const fw_status refused = model->kind == FW_FEATURES_PEAK_SHAPE
                                  ? check_peak_shape(model, facts)
                                  : check_range_bins(model, facts);
    if (refused != FW_OK) return refused;
    fw_window_shape shape;
    return fw_window_find((fw_window)fw_read_u16(facts + 16), model->chirp.n_samples, &shape);
}

/* What is made of a frame: the fields that both kinds share, and of the rest those of its own. */
static void read_features(const uint8_t* facts, fw_model* model) {
    const uint16_t steps = fw_read_u16(facts + 22);
    const float target_bin = fw_read_f32(facts + 24), floor_lsb = fw_read_f32(facts + 28);
    model->descriptor = (fw_extract_config){.first_bin = fw_read_u16(facts + 12),
                                            .n_bins = fw_read_u16(facts + 14),
                                            .window = (fw_window)fw_read_u16(facts + 16),
                                            .integration = (fw_integration)fw_read_u16(facts + 18),
                                            .path = (fw_range_path)fw_read_u16(facts + 20)};
    model->search_first = fw_read_u16(facts + 32);
    model->n_search = fw_read_u16(facts + 34);
    if (model->kind == FW_FEATURES_PEAK_SHAPE) {
        model->shape = (fw_relative_config){.search_first = model->search_first,
                                            .n_search = model->n_search,
                                            .n_around = model->descriptor.n_bins,
                                            .window = model->descriptor.window,
                                            .target_bin = target_bin,
                                            .floor_lsb = floor_lsb};
        model->descriptor.first_bin = model->search_first;
        model->descriptor.n_bins = model->n_search;
        return;
    }
    model->normalise = (fw_normalise_config){.align = (steps & 1u) != 0,
                                             .compensate_range = (steps & 2u) != 0,
                                             .logarithm = (steps & 4u) != 0,
                                             .target_bin = target_bin,
                                             .floor_lsb = floor_lsb};
}

static size_t feature_count(const fw_model* model) {
    return model->kind == FW_FEATURES_PEAK_SHAPE ? fw_relative_features(&model->shape)
                                                 : model->descriptor.n_bins;
}

static fw_status read_facts(const uint8_t* facts, fw_model* model) {
    read_chirp(facts + 36, &model->chirp);
    if (!chirp_in_range(&model->chirp)) return FW_ERR_SHAPE;
    model->kind = (fw_feature_kind)fw_read_u16(facts + 10);
    model->arithmetic = (fw_arithmetic)fw_read_u16(facts);
    model->has_monitor = fw_read_u16(facts + 2) == 1;
    model->n_features = fw_read_u16(facts + 6);
    model->n_classes = fw_read_u16(facts + 8);
    read_features(facts, model);
    const fw_status refused = check_choices(model, facts);
    if (refused != FW_OK) return refused;
    if (model->n_features != feature_count(model) || model->n_classes == 0) return FW_ERR_SHAPE;
    if (model->n_features > FW_MODEL_MAX_FEATURES) return FW_ERR_SHAPE;
    return model->n_classes <= FW_MODEL_MAX_CLASSES ? FW_OK : FW_ERR_SHAPE;
}

fw_status fw_model_open(const void* blob, size_t n_bytes, fw_model* model) {
    if (blob == NULL || model == NULL) return FW_ERR_NULL;
    const uint8_t* const bytes = blob;
    const fw_status wrong_start = check_start(bytes, n_bytes);
    if (wrong_start != FW_OK) return wrong_start;

    fw_model opened = {0};
    const uint8_t* const facts = bytes + START_BYTES;
    const fw_status wrong_kind = check_kind(fw_read_u16(bytes + 4), fw_read_u16(facts + 10));
    if (wrong_kind != FW_OK) return wrong_kind;
    const fw_status wrong_facts = read_facts(facts, &opened);
    if (wrong_facts != FW_OK) return wrong_facts;
    const fw_model_widths widths = {.n_layers = fw_read_u16(facts + 4),
                                    .n_out = {fw_read_u16(facts + 62), fw_read_u16(facts + 64),
                                              fw_read_u16(facts + 66), fw_read_u16(facts + 68)}};
    opened.whole.input_levels = fw_read_f32(facts + 72);
    opened.suspicious_squared = fw_read_f32(facts + 76);
    fw_blob_rest rest = {.next = bytes + MIN_BYTES, .n_left = n_bytes - MIN_BYTES};
    const fw_status wrong_arrays = fw_model_read_arrays(&rest, &widths, &opened);
    if (wrong_arrays != FW_OK) return wrong_arrays;
    *model = opened;
    return FW_OK;
}

fw_status fw_model_accepts_chirp(const fw_model* model, const fw_chirp* running) {
    if (model == NULL || running == NULL) return FW_ERR_NULL;
    const fw_chirp* const own = &model->chirp;
    const bool same =
        own->start_khz == running->start_khz && own->slope_khz_us == running->slope_khz_us &&
        own->sample_rate_hz == running->sample_rate_hz && own->n_samples == running->n_samples &&
        own->skip_samples == running->skip_samples && own->n_rx == running->n_rx &&
        own->n_chirps == running->n_chirps && own->high_pass_hz_10 == running->high_pass_hz_10 &&
        own->gain_db_100 == running->gain_db_100 && own->adc_bits == running->adc_bits;
    return same ? FW_OK : FW_ERR_CHIRP;
}

fw_status fw_model_accepts_frame(const fw_model* model, const fw_frame* frame) {
    if (model == NULL || frame == NULL) return FW_ERR_NULL;
    const fw_chirp* const own = &model->chirp;
    const bool same = own->n_samples == frame->n_samples && own->n_rx == frame->n_rx &&
                      own->n_chirps == frame->n_chirps;
    return same ? FW_OK : FW_ERR_GEOMETRY;
}
