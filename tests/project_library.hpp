#pragma once

#include "materials/library.hpp"

namespace specula {

/// The project's own materials, read once.
inline const Library& library() {
    static const Library read(SPECULA_SOURCE_DIR "/materials/library");
    return read;
}

}  // namespace specula
