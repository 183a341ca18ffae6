#pragma once

#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// An array in NumPy's file format, versions 1 to 3; its numbers stay where they are.
/// @eq  NumPy enhancement proposal 1, "A simple file format for NumPy arrays"
struct NpyArray {
    char kind = 'f';             ///< i, u, f, c (complex), b (bool), U or S (text)
    std::size_t item_bytes = 8;  ///< of one element
    bool big_endian = false;
    bool fortran_order = false;
    std::vector<std::size_t> shape;
    std::size_t data_offset = 0;  ///< of the first element in the file
    Bytes data;                   ///< exactly size() * item_bytes

    std::size_t size() const;
    /// Element i in the order of the file, as a number; the real part of a complex one.
    double real(std::size_t i) const;
    double imaginary(std::size_t i) const;
    /// Element i of an array of texts, without its padding; beyond ASCII: '?'.
    std::string text(std::size_t i) const;
    bool is_number() const { return kind != 'U' && kind != 'S'; }
};

/// @in  bytes  the whole file; must outlive the array
/// Throws InputError with the byte where the file is no such array, holds pickled Python objects
/// (which are programs, and never run), or has another size than its header says.
NpyArray read_npy(Bytes bytes);

/// A file of version 1: header for `descr` ("<i2", "<f8") and shape, then `data`.
std::string write_npy(const std::string& descr, const std::vector<std::size_t>& shape,
                      const std::string& data);

}  // namespace specula
