#include "sim/recording/dca1000_packets.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::string payload_of(std::size_t n) {
    std::string payload;
    for (std::size_t i = 0; i < n; ++i) payload += static_cast<char>(i * 7 + i / 256);
    return payload;
}

std::string packet_refusal(const std::string& packets) {
    return message_of([&] { return dca1000_payload(bytes_in(packets)); });
}

TEST_CASE("a payload comes back from its packets, whatever its length", "[recording]") {
    for (const std::size_t n : {0u, 1u, 1455u, 1456u, 1457u, 5000u}) {
        const std::string payload = payload_of(n);
        const std::string packets = dca1000_packets(bytes_in(payload));
        CHECK(packets.size() == n + 10 * ((n + 1455) / 1456));
        CHECK(dca1000_payload(bytes_in(packets)) == payload);
    }
}

TEST_CASE("a packet begins with its number and the place of its payload", "[recording]") {
    const std::string packets = dca1000_packets(bytes_in(payload_of(3000)));
    CHECK(packets.substr(0, 10) == std::string("\x01\0\0\0\0\0\0\0\0\0", 10));
    CHECK(packets.substr(1466, 10) == std::string("\x02\0\0\0\xb0\x05\0\0\0\0", 10));  // 1456
}

TEST_CASE("lost, repeated and torn packets are told with their byte", "[recording]") {
    const std::string packets = dca1000_packets(bytes_in(payload_of(5000)));
    const std::size_t one = 1466;
    CHECK(packet_refusal(packets.substr(one)) ==
          "byte 0: packet 2 where 1 is due; is this a file of packets with their headers?");
    CHECK(packet_refusal(packets.substr(0, one) + packets.substr(2 * one)) ==
          "byte 1466: packet 3 where 2 is due; packets were lost; record again");
    CHECK(packet_refusal(packets.substr(0, one) + packets) ==
          "byte 1466: packet 1 where 2 is due; packets were lost; record again");
    std::string misplaced = packets;
    misplaced[one + 4] = 0;
    CHECK(packet_refusal(misplaced).rfind("byte 1470: packet 2 belongs at ", 0) == 0);
    CHECK(
        packet_refusal(packets.substr(0, one + 5)).find("the data end inside a packet's header") !=
        std::string::npos);
    CHECK(packet_refusal(packets.substr(0, one + 10)).find("a packet without payload") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
