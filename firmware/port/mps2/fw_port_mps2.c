/* SPDX-License-Identifier: Apache-2.0 */
/* The runner's port for QEMU's mps2-an386: files by Arm semihosting, the CMSDK UART, SysTick.
 * Semihosting for AArch32 and AArch64, Arm document IHI 0068; operation numbers are its. */
#include <string.h>

#include "../fw_port.h"
#include "fw_semihost.h"

#define SYS_OPEN 0x01
#define SYS_CLOSE 0x02
#define SYS_WRITE0 0x04
#define SYS_WRITE 0x05
#define SYS_READ 0x06
#define SYS_GET_CMDLINE 0x15
#define SYS_EXIT_EXTENDED 0x20
#define ADP_STOPPED_APPLICATION_EXIT 0x20026u
#define MODE_READ 1  /* "rb" */
#define MODE_WRITE 5 /* "wb" */

#define UART_DATA (*(volatile uint32_t*)0x40004000u)
#define UART_STATE (*(volatile uint32_t*)0x40004004u)
#define UART_CONTROL (*(volatile uint32_t*)0x40004008u)
#define UART_BAUD_DIVISOR (*(volatile uint32_t*)0x40004010u)
#define UART_SENDER_FULL 1u
#define UART_SENDER_ON 1u
#define UART_SMALLEST_DIVISOR 16u

#define SYSTICK_CONTROL (*(volatile uint32_t*)0xE000E010u)
#define SYSTICK_RELOAD (*(volatile uint32_t*)0xE000E014u)
#define SYSTICK_VALUE (*(volatile uint32_t*)0xE000E018u)
#define SYSTICK_LARGEST 0x00FFFFFFu
#define SYSTICK_ON_PROCESSOR_CLOCK 5u

#define CANARY 0x5AFE57ACu
extern uint32_t fw_stack_end[];

static int32_t call(uint32_t operation, const void* argument) {
    register uint32_t r0 __asm("r0") = operation;
    register const void* r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}

void fw_semihost_begin(void) {
    fw_stack_end[0] = fw_stack_end[1] = CANARY;
    UART_BAUD_DIVISOR = UART_SMALLEST_DIVISOR;
    UART_CONTROL = UART_SENDER_ON;
    SYSTICK_RELOAD = SYSTICK_LARGEST;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = SYSTICK_ON_PROCESSOR_CLOCK;
}

void fw_semihost_command_line(char line[], size_t n_bytes) {
    uint32_t block[2] = {(uint32_t)line, n_bytes};
    if (call(SYS_GET_CMDLINE, block) != 0) line[0] = '\0';
}

_Noreturn void fw_semihost_exit(int status) {
    const uint32_t block[2] = {ADP_STOPPED_APPLICATION_EXIT, (uint32_t)status};
    for (;;) call(SYS_EXIT_EXTENDED, block);
}

int fw_port_open(const char* path, bool writing) {
    const uint32_t block[3] = {(uint32_t)path, writing ? MODE_WRITE : MODE_READ, strlen(path)};
    return call(SYS_OPEN, block);
}

size_t fw_port_read(int file, void* bytes, size_t n_bytes) {
    const uint32_t block[3] = {(uint32_t)file, (uint32_t)bytes, n_bytes};
    return n_bytes - (uint32_t)call(SYS_READ, block); /* it returns how many are missing */
}

bool fw_port_write(int file, const void* bytes, size_t n_bytes) {
    const uint32_t block[3] = {(uint32_t)file, (uint32_t)bytes, n_bytes};
    return call(SYS_WRITE, block) == 0;
}

void fw_port_close(int file) {
    const uint32_t block[1] = {(uint32_t)file};
    (void)call(SYS_CLOSE, block);
}

void fw_port_print(const char* text) {
    (void)call(SYS_WRITE0, text);
}

bool fw_port_uart_begin(const char* path) {
    (void)path; /* the emulator was told where the UART goes */
    return true;
}

bool fw_port_uart_send(const uint8_t bytes[], size_t n_bytes) {
    for (size_t i = 0; i < n_bytes; ++i) {
        while ((UART_STATE & UART_SENDER_FULL) != 0) {
        }
        UART_DATA = bytes[i];
    }
    return true;
}

uint32_t fw_port_ticks(void) {
    return SYSTICK_LARGEST - SYSTICK_VALUE;
}

bool fw_port_stack_intact(void) {
    return fw_stack_end[0] == CANARY && fw_stack_end[1] == CANARY;
}
