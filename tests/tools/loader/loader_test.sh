#!/bin/sh
# loader_test.sh SPECULA SOURCE: tools/loader reads what this program writes, in processes that are
# forked and in ones that are spawned. Status 77 where python3-h5py is not installed.
python=/usr/bin/python3 # Debian's, which sees Debian's h5py
"$python" -c 'import h5py' 2>/dev/null || { echo "skipped: python3-h5py is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit
for seed in 1 2 3 4; do
    for material in plexiglass wood; do
        printf 'radar = "iwrl6432boost"\n[sample]\nmaterial = "%s"\nsize_mm = [100, 100]\nthickness_mm = 5\n[geometry]\nheight_mm = 450\n' \
            "$material" >scene.toml
        "$1" simulate scene.toml --seed "$seed" -o "$material$seed.h5" >/dev/null || exit
    done
done
"$python" "$2/tests/tools/loader/join_frames.py" joined.npz ./*.h5 || exit
"$1" import npz joined.npz --manifest joined.toml -o joined.h5 >/dev/null || exit
"$python" "$2/tests/tools/loader/loader_check.py" "$2/tools/loader" joined.h5
