#pragma once

#include <string>

#include "classifier/descriptor.hpp"

namespace specula {

/// What a line of `--descriptor` asks for; empty: range bins.
inline Descriptor asked_descriptor(const std::string& line, const fw_extract_config& range_bins) {
    if (!line.empty()) return parse_descriptor(line);
    Descriptor descriptor;
    descriptor.bins = range_bins;
    return descriptor;
}

}  // namespace specula
