#!/bin/sh
# Builds the fuzz targets with clang's libFuzzer and runs each for a while; prints one line per target.
#
#   fuzz_test.sh BUILD_FOLDER
#
# SPECULA_FUZZ_SECONDS  time per target, default 5; 60 and more find what hides deeper
# SPECULA_FUZZ_JOBS     targets at a time, default 2
# Ends with 77 (skipped) where there is no clang with libFuzzer (Debian: clang, libclang-rt-dev).

here=$(cd -- "$(dirname -- "$0")" && pwd)
build=${1:?usage: fuzz_test.sh BUILD_FOLDER}
seconds=${SPECULA_FUZZ_SECONDS:-5}
jobs=${SPECULA_FUZZ_JOBS:-2}

mkdir -p "$build" || exit 1
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' \
    >"$build/probe.cpp"
if ! clang++ -fsanitize=fuzzer,address "$build/probe.cpp" -o "$build/probe" >/dev/null 2>&1; then
    echo "skipped: clang++ with libFuzzer is not installed (Debian: clang libclang-rt-dev)"
    exit 77
fi

cmake -S "$here" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    >"$build/log" 2>&1 && cmake --build "$build" >>"$build/log" 2>&1 ||
    { cat "$build/log"; exit 1; }

# run NAME: a corpus grows in the build folder; seeds lie beside the target.
run() {
    mkdir -p "$build/corpus/$1" "$build/findings"
    set -- "$1" "$build/corpus/$1"
    [ ! -d "$here/seeds/$1" ] || set -- "$1" "$2" "$here/seeds/$1"
    target=$1
    shift
    if "$build/$target" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=2048 \
        -print_final_stats=1 -artifact_prefix="$build/findings/$target-" "$@" \
        >"$build/$target.log" 2>&1; then
        runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$target.log")
        echo "$target: $runs inputs in $seconds s, no finding"
    else
        echo "$target: FOUND something; the end of $build/$target.log:"
        tail -n 30 "$build/$target.log"
        : >"$build/failed"
    fi
}

rm -f "$build/failed"
running=0
for file in "$here"/*_fuzz.cpp; do
    run "$(basename "$file" .cpp)" &
    running=$((running + 1))
    if [ "$running" -ge "$jobs" ]; then
        wait
        running=0
    fi
done
wait
[ ! -e "$build/failed" ]
