#pragma once

#include <cstddef>

#include "classifier/json_field.hpp"
#include "classifier/model.hpp"

namespace specula {

/// The optional parts of a model file; reading throws InputError as JsonField does.

FloatJson batch_norm_json(const BatchNorm& norm);
BatchNorm read_batch_norm(const JsonField& field, std::size_t n);

FloatJson convolution_json(const Convolution& convolution);
/// @in  n_in  values that come in; whole positions of them
Convolution read_convolution(const JsonField& field, std::size_t n_in);

FloatJson measurement_json(const Measurement& measurement);
Measurement read_measurement(const JsonField& field);

struct MonitorShape {
    std::size_t n_features = 0;
    std::size_t n_classes = 0;
};
FloatJson monitor_json(const InputMonitor& monitor);
FloatJson prototypes_json(const InputPrototypes& prototypes);
InputPrototypes read_prototypes(const JsonField& field, std::size_t n_features);
InputMonitor read_monitor(const JsonField& field, const MonitorShape& shape);

}  // namespace specula
