#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// In which order a file holds its codes: names of axes, the slowest first, and their lengths.
///
/// Axes: recording, frame, chirp, tx, rx, sample, iq (in-phase and quadrature: length 2). One that
/// is not named has length 1.
struct AxisOrder {
    std::vector<std::string> axes;
    std::vector<std::size_t> shape;
};

/// Codes in the order of a dataset. Frames are those of all recordings, receivers are virtual ones:
/// frame = recording * n_frames + frame, rx = tx * n_rx + rx.
struct CodeCube {
    std::size_t n_recordings = 1;
    std::size_t n_frames = 0;  ///< of all recordings together
    std::size_t n_chirps = 1, n_rx = 1, n_samples = 1;
    std::vector<std::int16_t> in_phase{};    ///< (frame, chirp, rx, sample)
    std::vector<std::int16_t> quadrature{};  ///< the same, or empty
};

/// Throws InputError where a name is unknown or twice, where samples are not named, or where
/// lengths are not those of `codes`.
CodeCube arrange(std::span<const std::int16_t> codes, const AxisOrder& order);

/// The inverse: the codes of a cube of n_frames = recordings * frames in another order. Lengths
/// that are 0 in `order.shape` are filled in from the cube.
std::vector<std::int16_t> rearrange(const CodeCube& cube, AxisOrder order);

/// The one length that is 0 in `order.shape`, from the number of codes there are.
/// Throws InputError with the byte (2 per code) where the last of that axis is incomplete.
AxisOrder with_open_axis(AxisOrder order, std::size_t n_codes);

}  // namespace specula
