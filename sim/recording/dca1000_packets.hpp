#pragma once

#include "sim/recording/byte_span.hpp"

namespace specula {

/// The payload of a capture card's data packets (DCA1000, UDP port 4098), kept with their headers
/// one behind the other: u32 sequence from 1, u48 offset of the payload, at most 1456 bytes; the
/// last may be shorter. All little-endian.
/// @eq  loeens/xWRL6432-adc-reader utils/adc.py
/// Throws InputError with the byte where a packet is missing, repeated, out of order or cut off:
/// lost packets are not filled up, because zeros would look like a recording.
std::string dca1000_payload(Bytes packets);

/// The inverse: packets of 1456 bytes, the last shorter.
std::string dca1000_packets(Bytes payload);

}  // namespace specula
