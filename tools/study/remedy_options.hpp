#pragma once

#include "classifier/train.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// What a rung changes of how the network is trained; what its section does not name stays.
void read_remedy_options(Section& section, TrainOptions& options);

}  // namespace specula
