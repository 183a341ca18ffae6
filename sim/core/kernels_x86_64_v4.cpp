#include "sim/core/kernel_lanes.hpp"

namespace specula {

extern const Kernels kernels_x86_64_v4;
const Kernels kernels_x86_64_v4{"x86-64-v4", turn, normals, add_products, paths};

}  // namespace specula
