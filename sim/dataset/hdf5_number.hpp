#pragma once

#include <cstdint>

#include "sim/dataset/hdf5_library.hpp"

namespace specula {

/// HDF5's names for the numbers of tables: in memory, and little-endian in the file.
inline hid_t memory_type(const std::int16_t*) {
    return H5T_NATIVE_INT16;
}
inline hid_t memory_type(const std::int32_t*) {
    return H5T_NATIVE_INT32;
}
inline hid_t memory_type(const std::uint64_t*) {
    return H5T_NATIVE_UINT64;
}
inline hid_t memory_type(const std::uint8_t*) {
    return H5T_NATIVE_UINT8;
}
inline hid_t memory_type(const float*) {
    return H5T_NATIVE_FLOAT;
}
inline hid_t memory_type(const double*) {
    return H5T_NATIVE_DOUBLE;
}
inline hid_t file_type(const std::int16_t*) {
    return H5T_STD_I16LE;
}
inline hid_t file_type(const std::int32_t*) {
    return H5T_STD_I32LE;
}
inline hid_t file_type(const std::uint64_t*) {
    return H5T_STD_U64LE;
}
inline hid_t file_type(const std::uint8_t*) {
    return H5T_STD_U8LE;
}
inline hid_t file_type(const float*) {
    return H5T_IEEE_F32LE;
}
inline hid_t file_type(const double*) {
    return H5T_IEEE_F64LE;
}

}  // namespace specula
