#pragma once

#include "tests/project_catalogue.hpp"
#include "tools/serve/scene_request.hpp"

namespace specula {

inline const KnownNames& known() {
    static const KnownNames names = KnownNames::of(catalogue());
    return names;
}

}  // namespace specula
