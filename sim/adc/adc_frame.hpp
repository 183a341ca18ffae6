#pragma once

#include <cstdint>
#include <vector>

#include "firmware/fw_frame.h"

namespace specula {

/// ADC codes of one frame, (chirp, rx, sample): what real silicon also gives.
struct AdcFrame {
    int n_chirps = 0;
    int n_rx = 0;
    int n_samples = 0;
    std::vector<std::int16_t> codes;         ///< in phase
    std::vector<std::int16_t> quadrature{};  ///< as codes, of a complex receiver; else empty

    /// The frame as the firmware takes it; valid as long as this frame lives.
    fw_frame view() const {
        return {.samples = codes.data(),
                .n_chirps = static_cast<std::uint16_t>(n_chirps),
                .n_rx = static_cast<std::uint16_t>(n_rx),
                .n_samples = static_cast<std::uint16_t>(n_samples)};
    }
};

}  // namespace specula
