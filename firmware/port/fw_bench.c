/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_bench.h"

#include "../fw_classify.h"
#include "../fw_fft.h"
#include "../fw_hwa_fft.h"
#include "../fw_monitor.h"
#include "../fw_range_profile.h"
#include "../fw_softmax.h"
#include "../fw_uart.h"
#include "fw_port.h"

#define MAX_BINS (FW_MAX_SAMPLES / 2)

static float values[FW_MAX_SAMPLES];
static float features[FW_MODEL_MAX_FEATURES];
static float logits[FW_MODEL_MAX_CLASSES];
static float probabilities[FW_MODEL_MAX_CLASSES];
static fw_result result;

/* Not inlined and not empty to the compiler: a place in the trace. */
__attribute__((noinline)) void fw_bench_mark(void) {
    __asm volatile("");
}

static fw_status empty(const fw_bench* bench) {
    (void)bench;
    return FW_OK;
}

static fw_status open_model(const fw_bench* bench) {
    static fw_model opened;
    return fw_model_open(bench->blob, bench->blob_bytes, &opened);
}

static fw_status inspect(const fw_bench* bench) {
    return fw_frame_inspect(bench->frame, bench->model->chirp.adc_bits, &result.quality);
}

static fw_status window(const fw_bench* bench) {
    fw_window_shape shape;
    const fw_status status =
        fw_window_find(bench->model->descriptor.window, bench->frame->n_samples, &shape);
    return status == FW_OK ? fw_window_apply(&shape, bench->frame->samples, values) : status;
}

static fw_status fft(const fw_bench* bench) {
    for (size_t i = bench->frame->n_samples; i < FW_MAX_SAMPLES; ++i) values[i] = 0.0f;
    return fw_fft_real(values, fw_range_fft_size(bench->frame->n_samples));
}

static fw_status range_profile(const fw_bench* bench) {
    const fw_extract_config* const descriptor = &bench->model->descriptor;
    const fw_range_config config = {.n_samples = bench->frame->n_samples,
                                    .first_bin = descriptor->first_bin,
                                    .n_bins = descriptor->n_bins,
                                    .window = descriptor->window};
    return fw_range_profile(bench->frame->samples, &config, bench->scratch, bench->scratch_bytes,
                            values);
}

static fw_status hwa_fft(const fw_bench* bench) {
    const fw_hwa_config config = {.n_samples = bench->frame->n_samples,
                                  .window = bench->model->descriptor.window,
                                  .scaled_stages = FW_HWA_DEFAULT_SCALED_STAGES,
                                  .output_shift = FW_HWA_DEFAULT_OUTPUT_SHIFT};
    return fw_hwa_fft(bench->frame->samples, &config, bench->scratch, bench->scratch_bytes,
                      (int16_t*)bench->scratch, NULL);
}

static fw_status describe(const fw_bench* bench) {
    return fw_describe(bench->model, bench->frame, bench->scratch, bench->scratch_bytes, features);
}

static fw_status network(const fw_bench* bench) {
    return fw_infer(bench->model, features, bench->scratch, bench->scratch_bytes, logits, NULL);
}

static fw_status softmax(const fw_bench* bench) {
    return fw_softmax(logits, bench->model->n_classes, probabilities);
}

static fw_status energy(const fw_bench* bench) {
    return fw_energy(logits, bench->model->n_classes, &result.energy);
}

static fw_status mahalanobis(const fw_bench* bench) {
    if (!bench->model->has_monitor) return FW_OK;
    return fw_mahalanobis_squared(&bench->model->monitor, features, &result.squared);
}

static fw_status uart(const fw_bench* bench) {
    static uint32_t counts[MAX_BINS];
    static uint8_t bytes[4 * MAX_BINS + 256];
    const fw_uart_packet packet = {
        .frame_number = 1,
        .time_cycles = 0,
        .profile = counts,
        .n_bins = (uint16_t)(fw_range_fft_size(bench->frame->n_samples) / 2),
        .probabilities = probabilities,
        .n_classes = bench->model->n_classes,
        .label = 0};
    return fw_uart_write(&packet, bytes, sizeof bytes);
}

static fw_status classify(const fw_bench* bench) {
    return fw_classify(bench->model, bench->frame, bench->scratch, bench->scratch_bytes, &result);
}

typedef struct stage {
    const char* name;
    fw_status (*run)(const fw_bench* bench);
} stage;

static const stage stages[] = {
    {"empty", empty},     {"model_open", open_model},
    {"inspect", inspect}, {"window", window},
    {"fft", fft},         {"range_profile", range_profile},
    {"hwa_fft", hwa_fft}, {"describe", describe},
    {"network", network}, {"softmax", softmax},
    {"energy", energy},   {"mahalanobis", mahalanobis},
    {"uart_frame", uart}, {"classify", classify},
};

static void print_number(uint32_t number) {
    char digits[11];
    size_t at = sizeof digits - 1;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    fw_port_print(digits + at);
}

fw_status fw_bench_run(const fw_bench* bench) {
    for (size_t i = 0; i < sizeof stages / sizeof stages[0]; ++i) {
        const uint32_t begin = fw_port_ticks();
        for (uint32_t repeat = 0; repeat < bench->repeats; ++repeat) {
            fw_bench_mark();
            const fw_status status = stages[i].run(bench);
            fw_bench_mark();
            if (status != FW_OK) return status;
        }
        const uint32_t ticks = (fw_port_ticks() - begin) & 0x00FFFFFFu;
        fw_port_print("stage ");
        fw_port_print(stages[i].name);
        fw_port_print(" ");
        print_number(ticks);
        fw_port_print("\n");
    }
    return FW_OK;
}
