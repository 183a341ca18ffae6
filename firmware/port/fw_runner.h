/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_RUNNER_H
#define FW_RUNNER_H

/* The runner's memory: it holds one frame at a time, and fits RAM3 of the IWRL6432 (128 KB). */

#define FW_RUNNER_MAX_CODES 16384
#define FW_RUNNER_SCRATCH_BYTES 20480

#endif
