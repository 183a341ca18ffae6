#pragma once

#include <string>
#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// What the header of an .npy file says: a dictionary as Python writes it.
struct NpyHeader {
    std::string descr;
    bool fortran_order = false;
    std::vector<std::size_t> shape;
};

/// @in  text    e.g. {'descr': '<i2', 'fortran_order': False, 'shape': (3, 4), }
/// @in  offset  of the text in the file, for messages
/// Throws InputError with the byte that is wrong.
NpyHeader parse_npy_header(const std::string& text, std::size_t offset);

}  // namespace specula
