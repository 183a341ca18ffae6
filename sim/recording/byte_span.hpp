#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

/// A file's content, borrowed.
using Bytes = std::span<const std::uint8_t>;

inline Bytes bytes_in(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Throws InputError `byte N: problem; remedy`. Whoever knows the file puts its name before it.
[[noreturn]] inline void fail_at(std::size_t offset, const std::string& problem,
                                 const std::string& remedy) {
    throw InputError(format("byte {}: {}; {}", offset, problem, remedy));
}

/// Little-endian numbers; `size` bytes are there, or InputError says what was cut off.
inline std::uint64_t unsigned_at(Bytes bytes, std::size_t offset, std::size_t size,
                                 const char* what) {
    if (offset > bytes.size() || bytes.size() - offset < size)
        fail_at(bytes.size(), format("the data end inside {}", what), "is the file whole?");
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value |= static_cast<std::uint64_t>(bytes[offset + i]) << (8 * i);
    return value;
}

inline std::uint16_t u16_at(Bytes bytes, std::size_t offset, const char* what) {
    return static_cast<std::uint16_t>(unsigned_at(bytes, offset, 2, what));
}

inline std::uint32_t u32_at(Bytes bytes, std::size_t offset, const char* what) {
    return static_cast<std::uint32_t>(unsigned_at(bytes, offset, 4, what));
}

inline float f32_at(Bytes bytes, std::size_t offset, const char* what) {
    return std::bit_cast<float>(u32_at(bytes, offset, what));
}

/// Appends the low `size` bytes of a number, little-endian.
inline void append_number(std::string& out, std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) out += static_cast<char>((value >> (8 * i)) & 0xff);
}

}  // namespace specula
