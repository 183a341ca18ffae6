#include "tools/generate/preflight.hpp"

#include <sys/statvfs.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/generate/record_session.hpp"

namespace specula {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double enough_s = 0.5;
/// Of /label, /frame_hash, /group and /truth, which repeat themselves within a session and pack
/// well, and of the places of the chunks.
constexpr double column_bytes_per_frame = 40.0;
constexpr double spare = 1.05;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double packed_bytes(const FrameBlock& frames) {
    return static_cast<double>(frames.adc.bytes.size() + frames.adc_quadrature.bytes.size() +
                               sizeof(float) * frames.profile.size() +
                               sizeof(double) * frames.features.size()) +
           column_bytes_per_frame * static_cast<double>(frames.n_frames());
}

}  // namespace

Forecast forecast(const Recipe& recipe, const Library& materials) {
    const std::size_t n_classes = recipe.population.classes.size();
    const auto n_per_class = static_cast<std::size_t>(recipe.condition.sessions_per_class());
    // The first simulation of a process pays for what later ones find ready: it is not counted.
    record_session(recipe, materials, 0);
    const auto start = Clock::now();
    double bytes = 0.0, frames = 0.0;
    for (std::size_t label = 0; label < n_classes; ++label) {
        const FrameBlock block = record_session(recipe, materials, label * n_per_class);
        bytes += packed_bytes(block);
        frames += static_cast<double>(block.n_frames());
        if (seconds_since(start) > enough_s) break;
    }
    return {.bytes_per_frame = spare * bytes / frames,
            .seconds_per_frame = seconds_since(start) / frames};
}

double free_bytes(const std::filesystem::path& folder) {
    struct statvfs state = {};
    if (::statvfs(folder.c_str(), &state) == -1)
        throw SystemError(folder.string() +
                          ": cannot ask for its free space: " + std::strerror(errno));
    return static_cast<double>(state.f_bavail) * static_cast<double>(state.f_frsize);
}

void check_space(const std::filesystem::path& folder, double needed_bytes) {
    const double free = free_bytes(folder);
    if (needed_bytes > free)
        throw SystemError(
            format("{}: needs about {} and has {} free; make room, write elsewhere, "
                   "or take fewer worlds",
                   folder.string(), bytes_text(needed_bytes), bytes_text(free)));
}

std::string bytes_text(double bytes) {
    if (bytes < 1000.0) return format("{:.0f} B", bytes);
    const char* const units[] = {"kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (bytes /= 1000.0; bytes >= 999.5 && unit + 1 < std::size(units); ++unit) bytes /= 1000.0;
    return format("{:.3g} {}", bytes, units[unit]);
}

std::string seconds_text(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return format("{} s", whole);
    if (whole < 3600) return format("{}:{:02} min", whole / 60, whole % 60);
    return format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace specula
