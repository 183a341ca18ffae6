#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/core/format.hpp"

namespace specula {

/// FNV-1a, 64 bits, of a text's bytes, as 16 hexadecimal digits. Not proof against malice.
inline std::string text_hash(std::string_view text) {
    std::uint64_t hash = 14695981039346656037ull;
    for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211ull;
    return format("{:016x}", hash);
}

}  // namespace specula
