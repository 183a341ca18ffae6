#pragma once

#include "tools/generate/recipe.hpp"

namespace specula {

/// What a run will take, judged from a few of its sessions, simulated and timed.
struct Forecast {
    double bytes_per_frame = 0.0;    ///< in a finished file
    double seconds_per_frame = 0.0;  ///< on one thread
};

/// Simulates a session of one class after another for about half a second, and at least one.
Forecast forecast(const Recipe& recipe, const Library& materials);

/// Bytes that may still be written below a folder, by this user.
double free_bytes(const std::filesystem::path& folder);

/// Throws SystemError where the bytes do not fit.
void check_space(const std::filesystem::path& folder, double needed_bytes);

/// "768 B", "61.4 MB", "1.2 TB".
std::string bytes_text(double bytes);
/// "45 s", "3:20 min", "11:05 h".
std::string seconds_text(double seconds);

}  // namespace specula
