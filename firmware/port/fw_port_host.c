/* SPDX-License-Identifier: Apache-2.0 */
/* The runner's port for a computer with files: the C library's. */
#include <stdio.h>

#include "fw_port.h"

#define MAX_FILES 8

static FILE* files[MAX_FILES];
static int uart = FW_PORT_NO_FILE;

int fw_port_open(const char* path, bool writing) {
    for (int i = 0; i < MAX_FILES; ++i) {
        if (files[i] != NULL) continue;
        files[i] = fopen(path, writing ? "wb" : "rb");
        return files[i] == NULL ? FW_PORT_NO_FILE : i;
    }
    return FW_PORT_NO_FILE;
}

size_t fw_port_read(int file, void* bytes, size_t n_bytes) {
    return fread(bytes, 1, n_bytes, files[file]);
}

bool fw_port_write(int file, const void* bytes, size_t n_bytes) {
    return fwrite(bytes, 1, n_bytes, files[file]) == n_bytes;
}

void fw_port_close(int file) {
    if (fclose(files[file]) != 0) perror("fw_runner");
    files[file] = NULL;
}

void fw_port_print(const char* text) {
    fputs(text, stdout);
}

bool fw_port_uart_begin(const char* path) {
    uart = fw_port_open(path, true);
    return uart != FW_PORT_NO_FILE;
}

bool fw_port_uart_send(const uint8_t bytes[], size_t n_bytes) {
    return fw_port_write(uart, bytes, n_bytes);
}

uint32_t fw_port_ticks(void) {
    return 0;
}

bool fw_port_stack_intact(void) {
    return true;
}
