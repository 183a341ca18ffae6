#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "classifier/model.hpp"
#include "firmware/fw_model.h"

namespace specula {

/// The model as the firmware's blob (firmware/MODEL_FORMAT.md), ready for fw_model_open.
///
/// The library's own fw_model_open has accepted the bytes before they are returned.
/// @in  model  with its measurement, at most FW_MODEL_MAX_FEATURES features and
///             FW_MODEL_MAX_CLASSES classes
/// Throws InputError naming what the firmware cannot hold.
std::vector<std::uint8_t> model_blob(const Model& model, fw_arithmetic arithmetic);

/// A blob as a C11 source file: `const unsigned char <name>[]`, aligned for fw_model_open, and
/// `const size_t <name>_bytes`.
/// @in  name  a lower-case C identifier, at most 32 characters
/// Throws InputError for another name.
std::string blob_as_c(const std::vector<std::uint8_t>& blob, const std::string& name);

}  // namespace specula
