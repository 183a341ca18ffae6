/* SPDX-License-Identifier: Apache-2.0 */
/* From reset to main on a Cortex-M4F whose linker script is xwrl6432.ld. */
#include <stdint.h>
#include <string.h>

#include "fw_semihost.h"

extern uint8_t fw_data_load[], fw_data_begin[], fw_data_end[];
extern uint8_t fw_bss_begin[], fw_bss_end[];
extern uint32_t fw_stack_begin[];

int main(int argc, char* argv[]);
void fw_reset(void);

#define CPACR (*(volatile uint32_t*)0xE000ED88u)
#define FPU_ON (0xFu << 20)
#define CRASHED 99
#define MAX_ARGUMENTS 8

/* Any fault ends the program with a status of its own: a runner has nothing to go back to. */
static void fault(void) {
    fw_semihost_exit(CRASHED);
}

/* The initial stack pointer, then what to run on reset and on every exception. */
typedef union vector {
    uint32_t* stack;
    void (*run)(void);
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    {.stack = fw_stack_begin},
    {.run = fw_reset},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
    {.run = fault},
};

/* Parts the command line at its spaces, in place. */
static int split(char* line, char* argv[]) {
    int argc = 0;
    char* next = line;
    while (*next != '\0' && argc < MAX_ARGUMENTS) {
        while (*next == ' ') *next++ = '\0';
        if (*next == '\0') break;
        argv[argc++] = next;
        while (*next != '\0' && *next != ' ') ++next;
    }
    return argc;
}

void fw_reset(void) {
    CPACR |= FPU_ON; /* off at reset: the first floating-point instruction would fault */
    __asm volatile("dsb\n isb");
    memcpy(fw_data_begin, fw_data_load, (size_t)(fw_data_end - fw_data_begin));
    memset(fw_bss_begin, 0, (size_t)(fw_bss_end - fw_bss_begin));
    fw_semihost_begin();
    static char line[512];
    static char* argv[MAX_ARGUMENTS + 1];
    fw_semihost_command_line(line, sizeof line);
    fw_semihost_exit(main(split(line, argv), argv));
}
