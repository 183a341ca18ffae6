#pragma once

#include <functional>

namespace specula {

/// CPU seconds that the calling thread has used.
double thread_seconds();

/// CPU seconds of the whole process, all threads.
double process_seconds();

/// Seconds that have passed in the room.
double wall_seconds();

/// CPU seconds of the calling thread per call of `work`.
///
/// Calls it in batches until about `budget_s` is spent, three batches at least, and takes the
/// fastest: what disturbs a run only ever makes it slower. Of longer ones, two do, and one of a second.
/// @in  budget_s  > 0
double seconds_per_call(double budget_s, const std::function<void()>& work);

/// Largest resident memory of the process so far, in bytes; 0 where the system does not say.
double peak_memory_bytes();

}  // namespace specula
