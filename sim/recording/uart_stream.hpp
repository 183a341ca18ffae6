#pragma once

#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// One output packet of a TI demo, as far as it matters here: the range profile (TLV 302, or 303
/// where there is no 302) and the classifier's answer (TLV 1031).
struct UartFrame {
    std::uint32_t number = 0;
    std::size_t offset = 0;                ///< of the packet in the stream
    std::vector<std::uint32_t> profile{};  ///< (range bin), linear
    std::uint32_t class_type = 0;
    std::vector<float> probability{};  ///< (class); may be empty
};

/// Bytes that belong to no whole packet.
struct UartGap {
    std::size_t offset = 0;
    std::size_t bytes = 0;
    std::string reason;
};

struct UartStream {
    std::vector<UartFrame> frames;
    std::vector<UartGap> gaps;
};

/// Reads what a serial port gave: whatever is not a whole, sound packet is passed over, up to the
/// next magic word behind its first byte, and told in `gaps`.
///
/// A packet: magic 02 01 04 03 06 05 08 07, then u32 version, total length (with padding),
/// platform, frame number, cycles, objects, TLVs, sub-frame; TLVs of u32 type, u32 length (without
/// these 8 bytes) and payload. Little-endian.
/// @eq  TI mmWave L-SDK, MmwDemo_output_message; lengths verified on recordings of an IWRL6432
/// Throws nothing: a stream without packets has no frames.
UartStream read_uart(Bytes bytes);

/// Whether the firmware could have written it: 64 KB at most, and a class of those it has.
bool is_writable(const UartFrame& frame);

/// A packet as the firmware writes it (fw_uart_write): TLV 302 where there is a profile, TLV 1031
/// where there are probabilities.
/// @in  frame  is_writable
std::string uart_packet(const UartFrame& frame);

}  // namespace specula
