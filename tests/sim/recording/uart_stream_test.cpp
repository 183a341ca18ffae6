#include "sim/recording/uart_stream.hpp"

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

const std::string magic{"\x02\x01\x04\x03\x06\x05\x08\x07", 8};

/// A packet as the documentation of the format has it, byte by byte.
std::string packet(const std::string& tlvs, std::uint32_t n_tlvs, std::uint32_t number) {
    std::string bytes = magic;
    append_number(bytes, 0x05030002, 4);
    const std::size_t length = (40 + tlvs.size() + 31) / 32 * 32;
    append_number(bytes, length, 4);
    append_number(bytes, 0x000a6432, 4);
    append_number(bytes, number, 4);
    append_number(bytes, 0, 8);  // cycles, objects
    append_number(bytes, n_tlvs, 4);
    append_number(bytes, 0xffffffff, 4);
    bytes += tlvs;
    bytes.resize(length, '\0');
    return bytes;
}

std::string tlv(std::uint32_t type, const std::string& payload) {
    std::string bytes;
    append_number(bytes, type, 4);
    append_number(bytes, payload.size(), 4);
    return bytes + payload;
}

std::string profile(const std::vector<std::uint32_t>& bins) {
    std::string bytes;
    for (const std::uint32_t bin : bins) append_number(bytes, bin, 4);
    return bytes;
}

const std::string stats = tlv(306, std::string(24, 's'));
const std::string first = packet(tlv(302, profile({5, 0xffffffff, 7})) + stats, 2, 41);
const std::string second = packet(stats + tlv(302, profile({1, 2, 3})), 2, 42);

TEST_CASE("range profiles are found among other TLVs, padding passed over", "[recording]") {
    const std::string bytes = first + second;
    const UartStream stream = read_uart(bytes_in(bytes));
    CHECK(stream.gaps.empty());
    REQUIRE(stream.frames.size() == 2);
    CHECK(stream.frames[0].number == 41);
    CHECK(stream.frames[0].profile == std::vector<std::uint32_t>{5, 0xffffffff, 7});
    CHECK(stream.frames[1].number == 42);
    CHECK(stream.frames[1].offset == first.size());
    CHECK(stream.frames[1].profile == std::vector<std::uint32_t>{1, 2, 3});
}

TEST_CASE("after garbage of any kind the next packet is found", "[recording]") {
    // The last one: a packet that claims to reach into the next.
    std::string long_one = first;
    long_one[12] = static_cast<char>(0xff);
    std::string no_length = first;
    no_length.replace(12, 4, "\xff\xff\xff\xff");
    std::string long_tlv = first;
    long_tlv[44] = static_cast<char>(0xf0);
    for (const std::string& garbage :
         {std::string("mmwDemo:/>"), magic, magic.substr(0, 7), std::string("\x02\x01\x04", 3),
          first.substr(0, 41), no_length, long_tlv, std::string(1000, '\0')}) {
        const std::string bytes = garbage + second + garbage + first;
        const UartStream stream = read_uart(bytes_in(bytes));
        REQUIRE(stream.frames.size() == 2);
        CHECK(stream.frames[0].offset == garbage.size());
        CHECK(stream.frames[0].profile == std::vector<std::uint32_t>{1, 2, 3});
        CHECK(stream.frames[1].number == 41);
        std::size_t passed_over = 0;
        for (const UartGap& gap : stream.gaps) passed_over += gap.bytes;
        CHECK(passed_over == 2 * garbage.size());
        CHECK(stream.gaps.front().offset == 0);
    }
}

TEST_CASE("every byte of a stream is in a packet or in a gap, wherever it is cut", "[recording]") {
    const std::string bytes = "xx" + first + second;
    for (std::size_t kept = 0; kept <= bytes.size(); ++kept) {
        const std::string cut = bytes.substr(0, kept);
        const UartStream stream = read_uart(bytes_in(cut));
        std::size_t accounted = 0;
        for (const UartGap& gap : stream.gaps) accounted += gap.bytes;
        for (const UartFrame& frame : stream.frames)
            accounted += frame.number == 41 ? first.size() : second.size();
        CHECK(accounted == kept);
        CHECK(stream.frames.size() == (kept < 2 + first.size() ? 0u
                                       : kept < bytes.size()   ? 1u
                                                               : 2u));
    }
    const std::string cut = first + second.substr(0, 60);
    const UartStream stream = read_uart(bytes_in(cut));
    REQUIRE(stream.gaps.size() == 1);
    CHECK(stream.gaps[0].reason == "a packet of 96 bytes, of which 60 are there");
}

TEST_CASE("the minor profile stands in for the major one", "[recording]") {
    const std::string both = packet(tlv(303, profile({9})) + tlv(302, profile({8})), 2, 1);
    CHECK(read_uart(bytes_in(both)).frames.at(0).profile == std::vector<std::uint32_t>{8});
    const std::string minor = packet(tlv(303, profile({9})), 1, 1);
    CHECK(read_uart(bytes_in(minor)).frames.at(0).profile == std::vector<std::uint32_t>{9});
}

TEST_CASE("impossible probabilities make a packet unsound", "[recording]") {
    for (const float p : {-0.1f, 1.5f, std::numeric_limits<float>::quiet_NaN()}) {
        std::string answer;
        append_number(answer, 0, 4);
        append_number(answer, 1, 4);
        append_number(answer, std::bit_cast<std::uint32_t>(p), 4);
        const std::string bytes = packet(tlv(1031, answer), 1, 1);
        const UartStream stream = read_uart(bytes_in(bytes));
        CHECK(stream.frames.empty());
        CHECK(stream.gaps.at(0).reason.find("a probability that is none") != std::string::npos);
    }
}

TEST_CASE("a packet comes back as it was, and is laid out as documented", "[recording]") {
    const UartFrame frame{
        .number = 7, .profile = {1, 4294967295u, 0}, .class_type = 1, .probability = {0.25f, 0.1f}};
    const std::string bytes = uart_packet(frame);
    std::string answer;
    append_number(answer, 1, 4);
    append_number(answer, 2, 4);
    for (const float p : frame.probability)
        append_number(answer, std::bit_cast<std::uint32_t>(p), 4);
    CHECK(bytes == packet(tlv(302, profile(frame.profile)) + tlv(1031, answer), 2, 7));
    const UartStream stream = read_uart(bytes_in(bytes));
    REQUIRE(stream.frames.size() == 1);
    CHECK(stream.frames[0].profile == frame.profile);
    CHECK(stream.frames[0].probability == frame.probability);
    CHECK(stream.frames[0].class_type == 1);
    CHECK(stream.frames[0].number == 7);
    UartFrame beyond = frame;
    beyond.class_type = 2;
    CHECK_FALSE(is_writable(beyond));
    beyond = frame;
    beyond.profile.resize(16373);
    CHECK_FALSE(is_writable(beyond));
}

}  // namespace
}  // namespace specula
