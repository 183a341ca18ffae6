#pragma once

#include <vector>

namespace specula {

/// The descriptor of one class: mean and standard deviation over frames, (feature).
struct ClassProfile {
    std::vector<double> mean;
    std::vector<double> sd;
};

}  // namespace specula
