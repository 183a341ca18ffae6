#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace specula {

/// Calls `work(i)` for i in [0, n) on `threads` threads, each i once, in no promised order.
///
/// The one place that knows OpenMP. The first exception stops the handing out of work and is thrown
/// again when all threads are done. `done`, if given, counts finished items for a progress display.
void for_each_index(std::size_t n, int threads, const std::function<void(std::size_t)>& work,
                    std::atomic<std::size_t>* done = nullptr);

/// What the machine offers to this process.
int available_threads();

}  // namespace specula
