/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_SEMIHOST_H
#define FW_SEMIHOST_H

/* What only a start-up needs of Arm semihosting; the rest is fw_port.h. */

#include <stddef.h>

void fw_semihost_begin(void);
void fw_semihost_command_line(char line[], size_t n_bytes);
_Noreturn void fw_semihost_exit(int status);

#endif
