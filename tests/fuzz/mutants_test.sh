#!/bin/sh
# Reads damaged datasets under address and undefined-behaviour sanitizers; none may crash, hang, or
# be read with another content.
#
#   mutants_test.sh SPECULA SOURCE BUILD_FOLDER
#
# SPECULA_MUTANTS  how many, default 1000
# Ends with 77 (skipped) where there is no clang.
here=$(cd -- "$(dirname -- "$0")" && pwd)
build=${3:?usage: mutants_test.sh SPECULA SOURCE BUILD_FOLDER}
command -v clang++ >/dev/null 2>&1 || { echo "skipped: clang++ is not installed (Debian: clang)"; exit 77; }
mkdir -p "$build" || exit 1
cmake -S "$here" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    >"$build/mutants.log" 2>&1 && cmake --build "$build" --target dataset_mutants \
    >>"$build/mutants.log" 2>&1 || { cat "$build/mutants.log"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" simulate "$2/scenes/examples/metal_plate.toml" -o "$folder/one.h5" >/dev/null || exit
"$1" augment "$folder/one.h5" -o "$folder/seed.h5" --copies 5 --step noise=2 >/dev/null || exit
count=${SPECULA_MUTANTS:-1000}
export ASAN_OPTIONS=detect_leaks=0 # HDF5 forgets some 400 bytes where it gives a damaged file up
timeout 1200 "$build/dataset_mutants" "$folder/seed.h5" "$folder" "$count" || exit 1
echo "$count damaged files, no crash"

# What the program itself says: status 2 and one line that names the file.
for damage in 'head -c 700' 'tail -c +2' 'tr A-Z a-z'; do
    $damage <"$folder/seed.h5" >"$folder/bad.h5"
    for command in 'show bad.h5' 'diff seed.h5 bad.h5' 'augment bad.h5 -o x.h5 --step gain=1' \
        'train bad.h5 -o x.json' 'export datasheet bad.h5' 'export croissant bad.h5'; do
        # shellcheck disable=SC2086  # one word per argument
        said=$(cd "$folder" && "$1" $command 2>&1)
        status=$?
        case $status:$said in
        "2:specula: error: bad.h5: "*) ;;
        *) echo "$command after $damage: status $status: $said"; exit 1 ;;
        esac
    done
done
