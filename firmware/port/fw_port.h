/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_PORT_H
#define FW_PORT_H

/* What the runner needs of the machine it runs on. The library itself needs none of it. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FW_PORT_NO_FILE (-1)

/* Opens a file to read, or a new one to write; FW_PORT_NO_FILE if that fails. */
int fw_port_open(const char* path, bool writing);

/* Reads up to n_bytes; returns how many it got. */
size_t fw_port_read(int file, void* bytes, size_t n_bytes);

/* Writes all or returns false. */
bool fw_port_write(int file, const void* bytes, size_t n_bytes);

void fw_port_close(int file);

/* Text for a person or a program, on standard output. */
void fw_port_print(const char* text);

/* Bytes for the UART: the real one on a target, a file of this name on a host. Called once, before
 * the first fw_port_uart_send. */
bool fw_port_uart_begin(const char* path);
bool fw_port_uart_send(const uint8_t bytes[], size_t n_bytes);

/* A clock that only goes up; what a tick is, the port knows. 0 for ever where there is none. */
uint32_t fw_port_ticks(void);

/* Whether the words put at the end of the stack at start are still there; true where no stack is
 * watched. */
bool fw_port_stack_intact(void);

#endif
