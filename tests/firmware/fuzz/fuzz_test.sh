#!/bin/sh
# fuzz_test.sh SPECULA SOURCE [SECONDS]: damaged blobs, frames and packets through the firmware's
# readers, under the address and undefined-behaviour sanitizers; a few seconds for each.
# With clang, libFuzzer does the same better: see firmware/README.md. Status 77: no python3 here.

specula=$1
source=$2
seconds=${3:-2}
command -v python3 >/dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
set -e
here=$source/tests/firmware/fuzz
python3 "$here/make_seeds.py" "$folder"
for arithmetic in float int16 int8; do
    for model in model model_shape; do
        "$specula" export model "$folder/$model.json" --arithmetic $arithmetic \
            --blob "$folder/${model}_$arithmetic" >/dev/null
    done
done
sanitize="-fsanitize=address,undefined -fno-sanitize-recover=all -g -O1"
flags="-std=c11 -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"
# shellcheck disable=SC2086  # one word per flag
(cd "$folder" && cc $sanitize $flags -I"$source" -c "$source"/firmware/fw_*.c \
    "$here/fw_fuzz_driver.c")
for target in model injection uart; do
    # shellcheck disable=SC2086
    cc $sanitize $flags -I"$source" "$here/fw_fuzz_$target.c" "$folder"/*.o -lm \
        -o "$folder/fuzz_$target"
    printf '%s: ' $target
    ASAN_OPTIONS=abort_on_error=0 "$folder/fuzz_$target" "$seconds" $(ls "$folder"/$target* | grep -v json)
done
