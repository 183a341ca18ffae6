# SPDX-License-Identifier: Apache-2.0
"""onnx_check.py MODEL.onnx MODEL.json: onnx's own checker, then the graph computed by its nodes and
the model computed by its definition, both in double. Status 77 where onnx is not installed."""

import json
import sys

try:
    import numpy as np
    import onnx
    from onnx import numpy_helper
except ImportError:
    print("python3-onnx is not installed")
    sys.exit(77)

file = onnx.load(sys.argv[1])
onnx.checker.check_model(file, full_check=True)
definition = json.load(open(sys.argv[2]))


def array(key, of):
    return np.array(of[key], dtype=np.float64)


def by_definition(x):
    x = (x - array("input_mean", definition)) * array("input_scale", definition)
    for layer in definition["hidden"]:
        y = x @ array("weight", layer).T
        y = (y - array("mean", layer)) / np.sqrt(array("variance", layer) + 1e-5)
        x = np.maximum(0, array("gamma", layer) * y + array("beta", layer))
    logits = x @ array("weight", definition["output"]).T + array("bias", definition["output"])
    shares = np.exp(logits - logits.max(axis=1, keepdims=True))
    return logits, shares / shares.sum(axis=1, keepdims=True)


def by_graph(x):
    values = {t.name: numpy_helper.to_array(t).astype(np.float64) for t in file.graph.initializer}
    values["features"] = x
    for node in file.graph.node:
        a = [values[name] for name in node.input]
        if node.op_type == "Sub":
            result = a[0] - a[1]
        elif node.op_type == "Mul":
            result = a[0] * a[1]
        elif node.op_type == "Gemm":
            assert {t.name: t.i for t in node.attribute} == {"transB": 1}
            result = a[0] @ a[1].T + a[2]
        elif node.op_type == "Relu":
            result = np.maximum(0, a[0])
        else:
            assert node.op_type == "Softmax", node.op_type
            shares = np.exp(a[0] - a[0].max(axis=1, keepdims=True))
            result = shares / shares.sum(axis=1, keepdims=True)
        values[node.output[0]] = result
    return [values[output.name] for output in file.graph.output]


n = len(definition["input_mean"])
mean, scale = array("input_mean", definition), array("input_scale", definition)
x = mean + np.random.default_rng(1).normal(size=(100, n)) / np.maximum(scale, 1e-9)
for found, expected in zip(by_graph(x), by_definition(x)):
    # Folding rounds every weight once to float32: 6e-8 of sums of a few dozen terms.
    assert np.abs(found - expected).max() < 1e-4 * (1 + np.abs(expected).max())
names = {p.key: p.value for p in file.metadata_props}
assert [names[f"class_{c}"] for c in range(len(definition["class_names"]))] == definition["class_names"]
print("accepted by onnx", onnx.__version__, "and equal to the model's definition")
