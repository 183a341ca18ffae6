#pragma once

#include <atomic>

#include "sim/dataset/dataset.hpp"
#include "sim/session.hpp"

namespace specula {

/// How many sessions a condition has in all.
std::size_t session_count(const Condition& condition, const Population& population, int worlds);

/// All frames of a condition in `worlds` worlds, ordered by world, class, session and frame.
/// The same for any number of threads. `done` counts finished sessions,
/// `weak` those whose echo is so weak that physical optics is known to be off.
Dataset generate(const Bench& bench, const Condition& condition, int worlds, int threads,
                 std::atomic<std::size_t>* done = nullptr, std::size_t* weak = nullptr);

}  // namespace specula
