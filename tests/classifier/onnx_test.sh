#!/bin/sh
# onnx_test.sh SPECULA SOURCE: what `specula export model --onnx` writes is accepted by onnx's checker
# and computes what the model means. Status 77 where python3-onnx is not installed.
python=/usr/bin/python3 # Debian's, which sees Debian's onnx
[ -x "$python" ] || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" "$2/tests/firmware/fuzz/make_seeds.py" "$folder" || exit
"$1" export model "$folder/model.json" --onnx "$folder/model.onnx" >/dev/null || exit
"$python" "$2/tests/classifier/onnx_check.py" "$folder/model.onnx" "$folder/model.json"
