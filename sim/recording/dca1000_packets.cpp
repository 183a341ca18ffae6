#include "sim/recording/dca1000_packets.hpp"

#include <algorithm>

namespace specula {

namespace {

constexpr std::size_t header_bytes = 10;
constexpr std::size_t payload_bytes = 1456;

}  // namespace

std::string dca1000_payload(Bytes packets) {
    std::string payload;
    payload.reserve(packets.size());
    std::uint32_t expected = 1;
    for (std::size_t at = 0; at < packets.size(); ++expected) {
        const std::uint32_t sequence = u32_at(packets, at, "a packet's header");
        const std::uint64_t offset = unsigned_at(packets, at + 4, 6, "a packet's header");
        if (sequence != expected)
            fail_at(at, format("packet {} where {} is due", sequence, expected),
                    expected == 1 ? "is this a file of packets with their headers?"
                                  : "packets were lost; record again");
        if (offset != payload.size())
            fail_at(
                at + 4,
                format("packet {} belongs at {}, after {} bytes", sequence, offset, payload.size()),
                "packets were lost; record again");
        at += header_bytes;
        const std::size_t n = std::min(payload_bytes, packets.size() - at);
        if (n == 0) fail_at(at, "a packet without payload", "is the file whole?");
        payload.append(reinterpret_cast<const char*>(packets.data()) + at, n);
        at += n;
    }
    return payload;
}

std::string dca1000_packets(Bytes payload) {
    std::string out;
    std::uint32_t sequence = 1;
    for (std::size_t at = 0; at < payload.size(); at += payload_bytes) {
        append_number(out, sequence++, 4);
        append_number(out, at, 6);
        out.append(reinterpret_cast<const char*>(payload.data()) + at,
                   std::min(payload_bytes, payload.size() - at));
    }
    return out;
}

}  // namespace specula
