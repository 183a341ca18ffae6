#pragma once

#include <cstddef>
#include <functional>

namespace specula {

/// Does `part(i)` for i in [0, n), each once, in any order, perhaps several at a time: how a stage
/// hands out work without knowing of threads or progress displays.
using ForEach = std::function<void(std::size_t n, const std::function<void(std::size_t)>& part)>;

inline void one_by_one(std::size_t n, const std::function<void(std::size_t)>& part) {
    for (std::size_t i = 0; i < n; ++i) part(i);
}

}  // namespace specula
