#pragma once

#include "scenes/catalogue.hpp"

namespace specula {

/// The project's own materials, radars and scenes, read once.
inline const Catalogue& catalogue() {
    static const Catalogue opened = Catalogue::open(SPECULA_SOURCE_DIR);
    return opened;
}

}  // namespace specula
