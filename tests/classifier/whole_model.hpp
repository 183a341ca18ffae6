#pragma once

#include <vector>

#include "classifier/model_blob.hpp"
#include "firmware/fw_bytes.h"
#include "firmware/fw_crc32.h"
#include "tests/classifier/naive_model.hpp"

namespace specula {

using Blob = std::vector<std::uint8_t>;

/// A model of the default shape with everything a blob can carry.
inline Model whole_model() {
    Model model = random_model({12, 16, 16, 5});
    model.input_mean.assign(12, 30.0f);
    model.input_scale.assign(12, 0.05f);
    model.measurement =
        Measurement{.chirp = {57'500'000, 150'000, 5'000'000, 128, 28, 3, 1, 17'500, 4000, 12},
                    .descriptor = {6, 12, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, FW_RANGE_FLOAT}};
    InputMonitor monitor;
    monitor.mean.assign(12, 30.0f);
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j <= i; ++j) monitor.whitening.push_back(i == j ? 0.1f : 0.0f);
    monitor.centre.assign(60, 0.0f);
    monitor.suspicious_squared = 26.0f;
    model.monitor = monitor;
    return model;
}

/// One of the shape of the peak, likewise.
inline Model shape_model() {
    Model model = random_model({25, 8, 5});
    model.extractor = "peak_shape";
    model.provenance = {
        {"descriptor", "peak_shape 6 12 blackman align 11.5 range 11.5 search 4 20"}};
    model.input_mean.assign(25, 0.1f);
    model.input_scale.assign(25, 2.0f);
    model.measurement = whole_model().measurement;
    return model;
}

/// Bytes that the checksum of a blob agrees with again.
inline Blob resealed(Blob blob) {
    fw_write_u32(blob.data() + 12, fw_crc32(blob.data() + 16, blob.size() - 16));
    return blob;
}

inline fw_status open_status(const Blob& blob) {
    fw_model model;
    return fw_model_open(blob.data(), blob.size(), &model);
}

}  // namespace specula
