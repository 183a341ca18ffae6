#!/bin/sh
# loader_test.sh SPECULA SOURCE: tools/loader reads what this program writes, in processes that are
# forked and in ones that are spawned. Status 77 where python3-h5py is not installed.
python=/usr/bin/python3 # Debian's, which sees Debian's h5py
"$python" -c 'import h5py' 2>/dev/null || { echo "skipped: python3-h5py is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit
"$python" "$2/tests/tools/loader/make_recording.py" run.npz || exit
cat >run.toml <<'END'
[layout]
member = "frames"
trust_axes = true
[labels]
class = "material"
session = "run"
END
"$1" import npz run.npz --manifest run.toml -o run.h5 >/dev/null || exit
"$python" "$2/tests/tools/loader/loader_check.py" "$2/tools/loader" run.h5
