#include "sim/core/kernels.hpp"

namespace specula {

extern const Kernels kernels_x86_64, kernels_x86_64_v3, kernels_x86_64_v4;

std::vector<const Kernels*> all_kernels() {
    std::vector<const Kernels*> found{&kernels_x86_64};
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool has_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") &&
                        __builtin_cpu_supports("fma");
    if (has_v3) found.push_back(&kernels_x86_64_v3);
    if (has_v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        found.push_back(&kernels_x86_64_v4);
#endif
    return found;
}

const Kernels& kernels() {
    static const Kernels* const best = all_kernels().back();
    return *best;
}

}  // namespace specula
