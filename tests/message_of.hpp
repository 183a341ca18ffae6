#pragma once

#include <string>

#include "sim/core/error.hpp"

namespace specula {

/// What InputError says that `work` throws; "(no error)" where it throws none.
template <typename Work>
std::string message_of(const Work& work) {
    try {
        (void)work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "(no error)";
}

}  // namespace specula
