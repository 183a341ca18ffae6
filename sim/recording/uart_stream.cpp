#include "sim/recording/uart_stream.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace specula {

namespace {

constexpr std::array<std::uint8_t, 8> magic{2, 1, 4, 3, 6, 5, 8, 7};
constexpr std::size_t header_bytes = 40, tlv_header_bytes = 8, padding = 32;
constexpr std::size_t longest_packet = 1 << 20;
constexpr std::uint32_t profile_major = 302, profile_minor = 303, classification = 1031;
constexpr std::uint32_t sdk_version = 0x05030002, platform = 0x000a6432, no_subframe = 0xffffffff;

std::size_t find_magic(Bytes bytes, std::size_t from) {
    const auto found = std::search(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(),
                                   magic.begin(), magic.end());
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
        frame.probability.push_back(p);
    }
}

/// @in  packet  all of it, as long as its header says
UartFrame read_packet(Bytes packet) {
    UartFrame frame;
    frame.number = u32_at(packet, 20, "the header");
    const std::size_t n_tlvs = u32_at(packet, 32, "the header");
    std::vector<std::uint32_t> minor;
    std::size_t at = header_bytes;
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
    if (bytes.size() - at < header_bytes) return 0;
    const std::size_t length = u32_at(bytes, at + 12, "the header");
    return length < header_bytes || length > longest_packet ? 0 : length;
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

std::string uart_packet(const UartFrame& frame) {
    const bool classified = !frame.probability.empty();
    std::string tlvs;
    append_number(tlvs, profile_major, 4);
    append_number(tlvs, 4 * frame.profile.size(), 4);
    for (const std::uint32_t bin : frame.profile) append_number(tlvs, bin, 4);
    if (classified) {
        append_number(tlvs, classification, 4);
        append_number(tlvs, 8 + 4 * frame.probability.size(), 4);
        append_number(tlvs, frame.class_type, 4);
        append_number(tlvs, frame.probability.size(), 4);
        for (const float p : frame.probability)
            append_number(tlvs, std::bit_cast<std::uint32_t>(p), 4);
    }
    const std::size_t length = (header_bytes + tlvs.size() + padding - 1) / padding * padding;
    std::string packet(magic.begin(), magic.end());
    for (const std::uint64_t field :
         {std::uint64_t{sdk_version}, std::uint64_t{length}, std::uint64_t{platform},
          std::uint64_t{frame.number}, std::uint64_t{0}, std::uint64_t{0},
          std::uint64_t{classified ? 2u : 1u}, std::uint64_t{no_subframe}})
        append_number(packet, field, 4);
    packet += tlvs;
    packet.resize(length, '\0');
    return packet;
}

}  // namespace specula
