/* SPDX-License-Identifier: Apache-2.0 */
/* The library with files around it: one program for a host and for the target, so that what they
 * write can be compared byte for byte.
 *
 *   fw_runner run BLOB FRAMES RECORDS UART   frames (fw_injection.h) -> a record and a packet each
 *   fw_runner bench BLOB FRAMES REPEATS      clock ticks of every stage, on the first frame
 *   fw_runner test BLOB                      the self-test
 *
 * Exit status: 0, 1 where a file fails, 2 for wrong arguments or files, 3 for a failed self-test.
 */
#include <string.h>

#include "../fw_bytes.h"
#include "../fw_classify.h"
#include "../fw_exported_profile.h"
#include "../fw_injection.h"
#include "../fw_range_profile.h"
#include "../fw_selftest.h"
#include "../fw_uart.h"
#include "fw_bench.h"
#include "fw_port.h"
#include "fw_runner.h"

#define MAX_BLOB_BYTES 32768
#define RECORD_COUNTS 7
#define RECORD_SCORES 4
#define MAX_RECORD_BYTES \
    (4 * (RECORD_COUNTS + RECORD_SCORES) + 4 * (FW_MODEL_MAX_FEATURES + 2 * FW_MODEL_MAX_CLASSES))
#define MAX_UART_BYTES 2560 /* 512 bins and 16 classes */

static uint32_t blob[MAX_BLOB_BYTES / 4];
static int16_t samples[FW_RUNNER_MAX_CODES];
static uint32_t scratch[FW_RUNNER_SCRATCH_BYTES / 4];

static int complain(const char* what, const char* why) {
    fw_port_print("fw_runner: ");
    fw_port_print(what);
    fw_port_print(": ");
    fw_port_print(why);
    fw_port_print("\n");
    return 2;
}

static int load_model(const char* path, fw_model* model) {
    const int file = fw_port_open(path, false);
    if (file == FW_PORT_NO_FILE) return complain(path, "cannot be opened");
    const size_t n_bytes = fw_port_read(file, blob, sizeof blob);
    fw_port_close(file);
    const fw_status status = fw_model_open(blob, n_bytes, model);
    if (status != FW_OK) return complain(path, fw_status_name(status));
    if (fw_classify_scratch(model) > sizeof scratch) return complain(path, "needs more scratch");
    return 0;
}

/* Opens a file of frames; *file is at the first of them. */
static int open_frames(const char* path, fw_injection* frames, int* file) {
    uint8_t header[FW_INJECTION_HEADER_BYTES];
    *file = fw_port_open(path, false);
    if (*file == FW_PORT_NO_FILE) return complain(path, "cannot be opened");
    if (fw_port_read(*file, header, sizeof header) != sizeof header) {
        return complain(path, fw_status_name(FW_ERR_LENGTH));
    }
    const fw_status status = fw_injection_read_header(header, frames);
    if (status != FW_OK) return complain(path, fw_status_name(status));
    const uint64_t codes = (uint64_t)frames->n_samples * frames->n_rx * frames->n_chirps;
    return codes <= FW_RUNNER_MAX_CODES ? 0 : complain(path, "has larger frames than fit here");
}

/* The next frame of an opened file, in `samples`; samples = NULL if the file ends before it does.
 */
static fw_frame next_frame(const fw_injection* frames, int file) {
    const size_t n_bytes =
        (size_t)frames->n_samples * frames->n_rx * frames->n_chirps * sizeof(int16_t);
    const bool whole = fw_port_read(file, samples, n_bytes) == n_bytes;
    return (fw_frame){.samples = whole ? samples : NULL,
                      .n_chirps = frames->n_chirps,
                      .n_rx = frames->n_rx,
                      .n_samples = frames->n_samples};
}

static uint8_t* put_floats(uint8_t* place, const float values[], size_t n) {
    for (size_t i = 0; i < n; ++i, place += 4) fw_write_f32(place, values[i]);
    return place;
}

/* One result as bytes; returns how many. */
static size_t make_record(const fw_model* model, fw_status status, const fw_result* result,
                          uint8_t out[]) {
    const uint32_t counts[RECORD_COUNTS] = {(uint32_t)status,
                                            result->quality.n_saturated,
                                            result->quality.n_dead_rows,
                                            result->n_saturated_bins,
                                            result->n_clipped_inputs,
                                            result->label,
                                            result->suspicious ? 1u : 0u};
    const float scores[RECORD_SCORES] = {result->probability, result->max_logit, result->energy,
                                         result->squared};
    uint8_t* place = out;
    for (size_t i = 0; i < RECORD_COUNTS; ++i, place += 4) fw_write_u32(place, counts[i]);
    place = put_floats(place, scores, RECORD_SCORES);
    place = put_floats(place, result->features, model->n_features);
    place = put_floats(place, result->logits, model->n_classes);
    place = put_floats(place, result->probabilities, model->n_classes);
    return (size_t)(place - out);
}

/* The whole spectrum as TI sends it, and the probabilities. */
static bool send_packet(const fw_model* model, const fw_frame* frame, uint32_t number,
                        const fw_result* result) {
    static float amplitude[FW_MAX_SAMPLES / 2];
    static uint32_t counts[FW_MAX_SAMPLES / 2];
    static uint8_t bytes[MAX_UART_BYTES];
    const uint16_t n_bins = (uint16_t)(fw_range_fft_size(frame->n_samples) / 2);
    fw_extract_config whole = model->descriptor;
    whole.first_bin = 0;
    whole.n_bins = n_bins;
    fw_window_shape window;
    fw_status status = fw_extract(frame, &whole, scratch, sizeof scratch, amplitude);
    if (status == FW_OK) status = fw_window_find(whole.window, frame->n_samples, &window);
    if (status == FW_OK) status = fw_exported_from_amplitude(&window, amplitude, n_bins, counts);
    const fw_uart_packet packet = {.frame_number = number,
                                   .time_cycles = 0, /* would differ from machine to machine */
                                   .profile = counts,
                                   .n_bins = n_bins,
                                   .probabilities = result->probabilities,
                                   .n_classes = model->n_classes,
                                   .label = result->label};
    if (status == FW_OK) status = fw_uart_write(&packet, bytes, sizeof bytes);
    return status == FW_OK &&
           fw_port_uart_send(bytes, fw_uart_size(packet.n_bins, packet.n_classes));
}

/* The model and the frames that argv[2] and argv[3] name; 0, or what to exit with. */
static int open_inputs(char* argv[], fw_model* model, fw_injection* frames, int* in) {
    const int failed = load_model(argv[2], model);
    return failed != 0 ? failed : open_frames(argv[3], frames, in);
}

/* Every frame of an opened file to a record and a packet; 0, or what to exit with. */
static int run_frames(const fw_model* model, const fw_injection* frames, int in, int out) {
    static uint8_t record[MAX_RECORD_BYTES];
    for (uint32_t i = 0; i < frames->n_frames; ++i) {
        const fw_frame frame = next_frame(frames, in);
        if (frame.samples == NULL) return 2;
        fw_result result = {0};
        const fw_status status = fw_classify(model, &frame, scratch, sizeof scratch, &result);
        const size_t n_bytes = make_record(model, status, &result, record);
        if (!fw_port_write(out, record, n_bytes)) return 1;
        if (status == FW_OK && !send_packet(model, &frame, i, &result)) return 1;
    }
    return 0;
}

static int run(char* argv[]) {
    fw_model model;
    fw_injection frames;
    int in = FW_PORT_NO_FILE;
    const int failed = open_inputs(argv, &model, &frames, &in);
    if (failed != 0) return failed;
    const int out = fw_port_open(argv[4], true);
    if (out == FW_PORT_NO_FILE) return complain(argv[4], "cannot be written");
    if (!fw_port_uart_begin(argv[5])) return complain(argv[5], "cannot be written");
    const int ended = run_frames(&model, &frames, in, out);
    uint8_t beyond;
    const bool goes_on = ended == 0 && fw_port_read(in, &beyond, 1) != 0;
    fw_port_close(in);
    fw_port_close(out);
    if (ended == 2) return complain(argv[3], "ends before the last frame its header promises");
    if (ended != 0) return ended;
    if (goes_on) return complain(argv[3], "goes on behind the last frame its header promises");
    return fw_port_stack_intact() ? 0 : complain("stack", "is overrun");
}

/* A whole number of 1 to 5 digits; 0 for anything else. */
static uint32_t read_repeats(const char* text) {
    uint32_t repeats = 0;
    size_t n = 0;
    for (; text[n] >= '0' && text[n] <= '9' && n < 5; ++n) {
        repeats = 10 * repeats + (uint32_t)(text[n] - '0');
    }
    return text[n] == '\0' ? repeats : 0;
}

static int bench(char* argv[]) {
    fw_model model;
    fw_injection frames;
    int in = FW_PORT_NO_FILE;
    const int failed = open_inputs(argv, &model, &frames, &in);
    if (failed != 0) return failed;
    const fw_frame frame = next_frame(&frames, in);
    fw_port_close(in);
    if (frame.samples == NULL) return complain(argv[3], "ends inside its first frame");
    const uint32_t repeats = read_repeats(argv[4]);
    if (repeats == 0) return complain(argv[4], "is no number of repeats, 1 to 99999");
    const fw_bench job = {.model = &model,
                          .blob = blob,
                          .blob_bytes = fw_read_u32((const uint8_t*)blob + 8),
                          .frame = &frame,
                          .scratch = scratch,
                          .scratch_bytes = sizeof scratch,
                          .repeats = repeats};
    const fw_status status = fw_bench_run(&job);
    return status == FW_OK ? 0 : complain("bench", fw_status_name(status));
}

static int test(char* argv[]) {
    fw_model model;
    const int failed = load_model(argv[2], &model);
    if (failed != 0) return failed;
    fw_selftest_report report;
    const fw_status status = fw_selftest(scratch, sizeof scratch, &report);
    const bool intact = fw_port_stack_intact();
    fw_port_print(status == FW_OK && intact ? "self-test passed\n" : "self-test FAILED\n");
    return status == FW_OK && intact ? 0 : 3;
}

int main(int argc, char* argv[]) {
    if (argc == 6 && strcmp(argv[1], "run") == 0) return run(argv);
    if (argc == 5 && strcmp(argv[1], "bench") == 0) return bench(argv);
    if (argc == 3 && strcmp(argv[1], "test") == 0) return test(argv);
    return complain("arguments", "run BLOB FRAMES RECORDS UART, bench BLOB FRAMES N or test BLOB");
}
