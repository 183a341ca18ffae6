#include "sim/core/kernel_lanes.hpp"

namespace specula {

extern const Kernels kernels_x86_64;
const Kernels kernels_x86_64{"x86-64", turn, normals, add_products, paths};

}  // namespace specula
