#pragma once

#include "materials/electrics.hpp"

namespace specula {

/// A medium with a grain in the plane of its face: what it is to a field along the grain and to one
/// across. Without a grain both are the same.
struct Grained {
    Electrics along;
    Electrics across;
};

}  // namespace specula
