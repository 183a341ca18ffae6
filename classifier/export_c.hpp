#pragma once

#include <string>

#include "classifier/model.hpp"

namespace specula {

/// A model as C11 source for the firmware: the texts of two files that belong together.
struct ExportedModel {
    std::string header_name;  ///< fw_model_<name>.h
    std::string header;
    std::string source_name;  ///< fw_model_<name>.c
    std::string source;
};

/// The folded model as `const fw_mlp fw_model_<name>` and its class names as
/// `fw_model_<name>_classes`: constant data only, so that it stays in flash.
///
/// Literals have nine digits: a compiler reads back the very floats the host uses.
/// @in  name  a lower-case C identifier, at most 32 characters
/// Throws InputError for another name.
ExportedModel export_c(const Model& model, const std::string& name);

/// Throws InputError unless `name` is a lower-case C identifier of at most 32 characters.
void check_c_name(const std::string& name);

}  // namespace specula
