#!/bin/sh
# verify_firmware_test.sh SPECULA [OPTIONS]: the builds of the firmware agree bit for bit and stay within
# their budgets. Status 77 where the tools for the target are missing; ./specula test installs them.
command -v arm-none-eabi-gcc >/dev/null && command -v qemu-system-arm >/dev/null || exit 77
specula=$1
shift
exec "$specula" verify-firmware --frames 200 "$@"
