#pragma once

#include <cstdint>

#include "sim/core/document.hpp"

namespace specula {

/// The key `seed`: a whole number from 0 to 2^64 - 1. TOML's own numbers end at 2^63 - 1; larger ones
/// stand in quotes. Throws InputError as the functions of Section do.
std::uint64_t read_seed(Section& section);

}  // namespace specula
