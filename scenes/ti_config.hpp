#pragma once

#include "scenes/radar.hpp"

namespace specula {

/// Whether a radar's name is that of a TI command file.
bool is_ti_config(const std::filesystem::path& file);

/// The board as a TI .cfg sets it up: channels, chirp, frame, gain, antenna geometry.
///
/// What the board's file says of antennas, noise, leakage and the chip's limits stays. Commands
/// that only concern processing on the chip have no effect; unknown ones, and such as change what
/// is recorded but are not simulated, become warnings of the radar. Throws InputError with the line
/// for wrong types and for a chirp that the chip cannot make.
/// @in  board  a radar file whose limits list the high-pass corners by code
Radar read_ti_config(const std::filesystem::path& file, const std::filesystem::path& board);

}  // namespace specula
