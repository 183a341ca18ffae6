#include "sim/core/kernel_lanes.hpp"

namespace specula {

extern const Kernels kernels_x86_64_v3;
const Kernels kernels_x86_64_v3{"x86-64-v3", turn, normals, add_products, paths};

}  // namespace specula
