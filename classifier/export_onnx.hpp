#pragma once

#include <cstdint>
#include <vector>

#include "classifier/model.hpp"

namespace specula {

/// The folded model as an ONNX file (IR version 7, operator set 13): input `features` (N, features)
/// in the unit of the extractor, outputs `logits` and `probabilities` (N, classes). Its numbers are
/// the very floats of the firmware; class names and provenance travel as metadata.
/// @eq  https://github.com/onnx/onnx/blob/v1.12.0/onnx/onnx.proto
std::vector<std::uint8_t> export_onnx(const Model& model);

}  // namespace specula
