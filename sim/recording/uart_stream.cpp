#include "sim/recording/uart_stream.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "firmware/fw_uart.h"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr std::array<std::uint8_t, 8> packet_magic{2, 1, 4, 3, 6, 5, 8, 7};
constexpr std::size_t packet_head_bytes = FW_UART_HEADER_BYTES, tlv_header_bytes = 8;
constexpr std::size_t longest_packet = 1 << 20;
constexpr std::uint32_t profile_major = FW_UART_TLV_PROFILE, profile_minor = 303,
                        classification = FW_UART_TLV_CLASSES;

std::size_t find_magic(Bytes bytes, std::size_t from) {
    const auto found = std::search(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(),
                                   packet_magic.begin(), packet_magic.end());
    return static_cast<std::size_t>(found - bytes.begin());
}

std::vector<std::uint32_t> read_profile(Bytes payload) {
    if (payload.size() % 4 != 0) fail_at(0, "a range profile that is no whole number of bins", "");
    std::vector<std::uint32_t> profile;
    for (std::size_t at = 0; at < payload.size(); at += 4)
        profile.push_back(u32_at(payload, at, "a profile"));
    return profile;
}

void read_classification(Bytes payload, UartFrame& frame) {
    frame.class_type = u32_at(payload, 0, "a classification");
    const std::size_t n = u32_at(payload, 4, "a classification");
    if (n == 0 || payload.size() != 8 + 4 * n)
        fail_at(4, "a classification whose count is not its length", "");
    for (std::size_t i = 0; i < n; ++i) {
        const float p = f32_at(payload, 8 + 4 * i, "a classification");
        if (!(p >= 0.0f && p <= 1.0f)) fail_at(8 + 4 * i, "a probability that is none", "");
        frame.probability.push_back(p + 0.0f);  // -0 becomes 0
    }
}

/// @in  packet  all of it, as long as its header says
UartFrame read_packet(Bytes packet) {
    UartFrame frame;
    frame.number = u32_at(packet, 20, "the header");
    const std::size_t n_tlvs = u32_at(packet, 32, "the header");
    std::vector<std::uint32_t> minor;
    std::size_t at = packet_head_bytes;
    for (std::size_t i = 0; i < n_tlvs; ++i) {
        const std::uint32_t type = u32_at(packet, at, "a TLV");
        const std::size_t length = u32_at(packet, at + 4, "a TLV");
        at += tlv_header_bytes;
        if (packet.size() - at < length) fail_at(at, "a TLV that goes beyond its packet", "");
        const Bytes payload = packet.subspan(at, length);
        if (type == profile_major) frame.profile = read_profile(payload);
        if (type == profile_minor) minor = read_profile(payload);
        if (type == classification) read_classification(payload, frame);
        at += length;
    }
    if (frame.profile.empty()) frame.profile = minor;
    return frame;
}

/// The length that a packet's header gives; 0 where it is impossible.
std::size_t packet_length(Bytes bytes, std::size_t at) {
    if (bytes.size() - at < packet_head_bytes) return 0;
    const std::size_t length = u32_at(bytes, at + 12, "the header");
    return length < packet_head_bytes || length > longest_packet ? 0 : length;
}

}  // namespace

UartStream read_uart(Bytes bytes) {
    UartStream stream;
    const auto pass_over = [&](std::size_t from, std::size_t to, const std::string& reason) {
        if (to > from) stream.gaps.push_back({from, to - from, reason});
    };
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t begin = find_magic(bytes, at);
        pass_over(at, begin, "no packet");
        if (begin == bytes.size()) break;
        const std::size_t length = packet_length(bytes, begin);
        std::string problem;
        if (length == 0)
            problem = "a packet whose header is cut off or gives an impossible length";
        else if (bytes.size() - begin < length)
            problem =
                format("a packet of {} bytes, of which {} are there", length, bytes.size() - begin);
        else
            try {
                stream.frames.push_back(read_packet(bytes.subspan(begin, length)));
                stream.frames.back().offset = begin;
            } catch (const InputError& error) {
                problem = std::string("a packet in which, at ") + error.what();
                problem.resize(problem.find(';'));
            }
        at = problem.empty() ? begin + length : find_magic(bytes, begin + 1);
        if (!problem.empty()) pass_over(begin, at, problem);
    }
    return stream;
}

bool is_writable(const UartFrame& frame) {
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
    if (frame.profile.size() > most || frame.probability.size() > most) return false;
    const auto n_bins = static_cast<std::uint16_t>(frame.profile.size());
    const auto n_classes = static_cast<std::uint16_t>(frame.probability.size());
    return fw_uart_size(n_bins, n_classes) <= FW_UART_MAX_BYTES &&
           (n_classes == 0 || frame.class_type < n_classes);
}

std::string uart_packet(const UartFrame& frame) {
    SPECULA_EXPECT(is_writable(frame));
    const fw_uart_packet packet{
        .frame_number = frame.number,
        .time_cycles = 0,
        .profile = frame.profile.data(),
        .n_bins = static_cast<std::uint16_t>(frame.profile.size()),
        .probabilities = frame.probability.data(),
        .n_classes = static_cast<std::uint16_t>(frame.probability.size()),
        .label = static_cast<std::uint16_t>(frame.probability.empty() ? 0 : frame.class_type)};
    std::vector<std::uint8_t> bytes(fw_uart_size(packet.n_bins, packet.n_classes));
    SPECULA_EXPECT(fw_uart_write(&packet, bytes.data(), bytes.size()) == FW_OK);
    return {bytes.begin(), bytes.end()};
}

}  // namespace specula
