#pragma once

#include "firmware/fw_model.h"
#include "scenes/radar.hpp"

namespace specula {

/// How features came about: the radar's chirp as a fingerprint, and the firmware's extractor. A
/// classifier is good for these alone.
struct Measurement {
    fw_chirp chirp{};
    fw_extract_config descriptor{};
};

/// The fingerprint of a radar. Frequencies are rounded to whole kHz or Hz, finer than the steps of
/// the IWRL6432 (1.17 MHz, 28.6 kHz/us).
/// Throws InputError where a number does not fit, e.g. a sample rate above 4.29 GHz.
Measurement measurement_of(const Radar& radar, const fw_extract_config& descriptor);

}  // namespace specula
