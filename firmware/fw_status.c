/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_status.h"

#define FW_STATUS_CASE(name) \
    case name:               \
        return #name;

const char* fw_status_name(fw_status status) {
    switch (status) { FW_STATUS_LIST(FW_STATUS_CASE) }
    return "unknown fw_status";
}
