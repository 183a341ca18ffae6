#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sim/core/error.hpp"

namespace specula {

/// Runs a reader on made-up bytes. It may read them or throw InputError; all else ends the program:
/// another exception, a wrong access (address sanitizer), undefined arithmetic.
template <typename Read>
int refuses_or_reads(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
        return 0;
    }
    return 0;
}

}  // namespace specula
