# SPDX-License-Identifier: Apache-2.0
"""make_seeds.py FOLDER: inputs for the fuzz targets to begin with, and a model for `specula export`."""

import json
import random
import struct
import sys

folder = sys.argv[1]
random.seed(1)


def number():
    return round(random.uniform(-1, 1), 3)


def layer(n_in, n_out):
    return {
        "weight": [[number() for _ in range(n_in)] for _ in range(n_out)],
        "gamma": [1.0] * n_out,
        "beta": [number() for _ in range(n_out)],
        "mean": [number() for _ in range(n_out)],
        "variance": [1.0] * n_out,
    }


model = {
    "format": "specula model",
    "version": 1,
    "extractor": "range_bins",
    "class_names": ["iron", "wood", "limestone"],
    "provenance": {"note": "for the fuzzer"},
    "input_mean": [30.0] * 12,
    "input_scale": [0.1] * 12,
    "measurement": {
        "start_khz": 57500000, "slope_khz_us": 150000, "sample_rate_hz": 5000000,
        "n_samples": 128, "skip_samples": 28, "n_rx": 3, "n_chirps": 1,
        "high_pass_hz_10": 17500, "gain_db_100": 4000, "adc_bits": 12,
        "first_bin": 6, "n_bins": 12, "window": "blackman", "integration": "mean",
        "range_fft": "float",
    },
    "monitor": {
        "mean": [30.0] * 12,
        "whitening": [0.1 if i == j else 0.0 for i in range(12) for j in range(i + 1)],
        "centre": [number() for _ in range(36)],
        "suspicious_squared": [26.0],
    },
    "hidden": [layer(12, 6)],
    "output": {"weight": [[number() for _ in range(6)] for _ in range(3)], "bias": [0.0, 0.1, 0.2]},
}
with open(folder + "/model.json", "w") as file:
    json.dump(model, file)

model["extractor"] = "peak_shape"
model["provenance"] = {"descriptor": "peak_shape 6 12 blackman align 11.5 range 11.5 search 4 20"}
model["input_mean"] = [0.1] * 25
model["input_scale"] = [2.0] * 25
model["monitor"] = {
    "mean": [0.1] * 25,
    "whitening": [2.0 if i == j else 0.0 for i in range(25) for j in range(i + 1)],
    "centre": [number() for _ in range(75)],
    "suspicious_squared": [44.0],
}
model["hidden"] = [layer(25, 6)]
with open(folder + "/model_shape.json", "w") as file:
    json.dump(model, file)

for name, shape in (("injection_a", (16, 2, 1, 2)), ("injection_b", (64, 1, 1, 1))):
    codes = shape[0] * shape[1] * shape[2] * shape[3]
    with open(folder + "/" + name, "wb") as file:
        file.write(struct.pack("<4I", *shape))
        file.write(struct.pack(f"<{codes}h", *(random.randint(-2048, 2047) for _ in range(codes))))

packet = bytes([2, 1, 4, 3, 6, 5, 8, 7])
packet += struct.pack("<8I", 0x05030002, 96, 0xA6432, 77, 9, 0, 2, 0xFFFFFFFF)
packet += struct.pack("<2I3I", 302, 12, 1, 2, 3) + struct.pack("<4I2f", 1031, 16, 1, 2, 0.25, 0.75)
with open(folder + "/uart", "wb") as file:
    file.write(2 * packet.ljust(96, b"\0"))
