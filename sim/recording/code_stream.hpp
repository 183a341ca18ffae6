#pragma once

#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// How 16-bit words of a stream become ADC codes.
enum class Packing {
    int16,           ///< the code itself
    rdif_swizzle_2,  ///< IWRL6432 raw data over RDIF, `adcLogging 1 0 2 0 0`: 12 bits, bit-swizzled
    lvds_iq,         ///< complex over two LVDS lanes (xWR16xx, 68xx): I0 I1 Q0 Q1, I2 I3 Q2 Q3 ...
};

/// Little-endian words -> codes in the order of the stream; lvds_iq gives I0 Q0 I1 Q1 ...
///
/// RDIF: words come in groups of four, W0..W3, of which 12 bits count. Bit i of the j-th code of a
/// group is bit 9 - 3 j + i/4 of W_{i mod 4}; codes are two's complement.
/// @eq  bit order: loeens/xWRL6432-adc-reader utils/adc.py; lanes: TI SWRA581, "xWR16xx/IWR6843
///      complex data format using DCA1000"
/// Throws InputError with the byte where a group is cut off or has bits beyond its 12.
std::vector<std::int16_t> unpack_codes(Bytes bytes, Packing packing);

/// The inverse. Throws InputError where a code needs more than 12 bits or a group is incomplete.
std::string pack_codes(std::span<const std::int16_t> codes, Packing packing);

}  // namespace specula
