#include "firmware/fw_uart.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/check.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t u32(const Bytes& bytes, std::size_t at) {
    return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

const std::vector<std::uint32_t> counts{1, 70000, 0xFFFFFFFF};
const std::vector<float> shares{0.25F, 0.75F};

fw_uart_packet packet() {
    return {.frame_number = 77,
            .time_cycles = 9,
            .profile = counts.data(),
            .n_bins = 3,
            .probabilities = shares.data(),
            .n_classes = 2,
            .label = 1};
}

Bytes written(const fw_uart_packet& what) {
    Bytes bytes(fw_uart_size(what.n_bins, what.n_classes), 0xEE);
    REQUIRE(fw_uart_write(&what, bytes.data(), bytes.size()) == FW_OK);
    return bytes;
}

}  // namespace

TEST_CASE("a packet has TI's header, blocks and padding", "[firmware]") {
    // 40 of header + 8 + 12 of profile + 8 + 8 + 8 of classes = 84, padded to 96.
    const Bytes bytes = written(packet());
    REQUIRE(bytes.size() == 96);
    CHECK(Bytes(bytes.begin(), bytes.begin() + 8) == Bytes{2, 1, 4, 3, 6, 5, 8, 7});
    CHECK(u32(bytes, 12) == 96);          // the packet's length counts its padding
    CHECK(u32(bytes, 16) == 0x000A6432);  // platform
    CHECK(u32(bytes, 20) == 77);
    CHECK(u32(bytes, 24) == 9);
    CHECK(u32(bytes, 28) == 0);  // detected objects
    CHECK(u32(bytes, 32) == 2);  // blocks
    CHECK(u32(bytes, 36) == 0xFFFFFFFF);
    CHECK(u32(bytes, 40) == 302);
    CHECK(u32(bytes, 44) == 12);  // a block's length does not count its own eight bytes
    CHECK(u32(bytes, 52) == 70000);
    CHECK(u32(bytes, 60) == 1031);
    CHECK(u32(bytes, 64) == 16);
    CHECK(u32(bytes, 68) == 1);
    CHECK(u32(bytes, 72) == 2);
    CHECK(u32(bytes, 76) == 0x3E800000);  // 0.25
    for (std::size_t i = 84; i < 96; ++i) CHECK(bytes[i] == 0);
}

TEST_CASE("an empty block is left out", "[firmware]") {
    auto what = packet();
    what.n_bins = 0;
    what.profile = nullptr;
    const Bytes bytes = written(what);
    CHECK(bytes.size() == 64);
    CHECK(u32(bytes, 32) == 1);
    CHECK(u32(bytes, 40) == 1031);
}

TEST_CASE("a reader finds packets in any stream that holds them", "[firmware]") {
    const Bytes one = written(packet());
    Bytes stream{9, 2, 1, 4, 3, 6, 5, 8};  // ends as a magic word begins, but does not go on
    stream.insert(stream.end(), one.begin(), one.end());
    stream.insert(stream.end(), {2, 1, 4, 4});
    stream.insert(stream.end(), one.begin(), one.end());
    stream.insert(stream.end(), one.begin(), one.begin() + 50);  // its end is still to come
    std::size_t at = 0, found = 0;
    for (;;) {
        fw_uart_view view{};
        std::size_t used = 0;
        const auto status = fw_uart_read(stream.data() + at, stream.size() - at, &view, &used);
        at += used;
        if (status == FW_ERR_LENGTH) break;
        REQUIRE(status == FW_OK);
        ++found;
        CHECK(view.frame_number == 77);
        CHECK(view.n_bins == 3);
        CHECK(view.n_classes == 2);
        CHECK(view.label == 1);
        CHECK(std::memcmp(view.profile, counts.data(), 12) == 0);
        CHECK(std::memcmp(view.probabilities, shares.data(), 8) == 0);
    }
    CHECK(found == 2);
    CHECK(stream.size() - at == 50);
}

TEST_CASE("a packet whose lengths contradict each other is skipped", "[firmware]") {
    for (const std::size_t at : {12, 32, 44, 64, 72}) {
        Bytes bytes = written(packet());
        bytes[at] = 0xFF;
        bytes[at + 1] = at == 12 ? 0 : 0x7F;
        if (at == 12) bytes[at] = 39;  // shorter than a header
        fw_uart_view view{};
        std::size_t used = 0;
        CHECK(fw_uart_read(bytes.data(), bytes.size(), &view, &used) == FW_ERR_VALUE);
        CHECK(used == 1);
    }
    const Bytes noise(100, 0x55);
    fw_uart_view view{};
    std::size_t used = 0;
    CHECK(fw_uart_read(noise.data(), noise.size(), &view, &used) == FW_ERR_MAGIC);
    CHECK(used == 100);
}

TEST_CASE("a packet that cannot be written leaves the bytes alone", "[firmware]") {
    Bytes bytes(96, 0xEE);
    const auto status = [&](fw_uart_packet what, std::size_t n) {
        return fw_uart_write(&what, bytes.data(), n);
    };
    CHECK(status(packet(), 95) == FW_ERR_SCRATCH);
    auto what = packet();
    what.profile = nullptr;
    CHECK(status(what, 96) == FW_ERR_NULL);
    what = packet();
    what.probabilities = nullptr;
    CHECK(status(what, 96) == FW_ERR_NULL);
    CHECK(bytes == Bytes(96, 0xEE));
    CHECK(fw_uart_write(nullptr, bytes.data(), 96) == FW_ERR_NULL);
}

TEST_CASE("what is written is what the reader takes: too long or untrue packets are refused",
          "[firmware]") {
    // (65536 - 40 - 8) / 4 = 16372 bins fill a packet; 20000 were once written and not read.
    std::vector<std::uint32_t> many(20000, 5);
    fw_uart_packet what{.frame_number = 1,
                        .time_cycles = 0,
                        .profile = many.data(),
                        .n_bins = 16372,
                        .probabilities = nullptr,
                        .n_classes = 0,
                        .label = 0};
    Bytes bytes = written(what);
    CHECK(bytes.size() == FW_UART_MAX_BYTES);
    fw_uart_view view{};
    std::size_t used = 0;
    CHECK(fw_uart_read(bytes.data(), bytes.size(), &view, &used) == FW_OK);
    CHECK(view.n_bins == 16372);
    for (const std::uint16_t n_bins : {16373, 20000}) {
        what.n_bins = n_bins;
        Bytes out(fw_uart_size(n_bins, 0));
        CHECK(fw_uart_write(&what, out.data(), out.size()) == FW_ERR_SHAPE);
    }
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (const float wrong : {none, -none, 2.0F, -0.25F, -0.0F, 1.0000001F}) {
        const std::vector<float> untrue{wrong, 0.5F};
        fw_uart_packet lie = packet();
        lie.probabilities = untrue.data();
        Bytes out(96, 0xEE);
        CHECK(fw_uart_write(&lie, out.data(), 96) == FW_ERR_VALUE);
        CHECK(out == Bytes(96, 0xEE));
        Bytes received = written(packet());
        std::memcpy(received.data() + 76, &wrong, 4);
        CHECK(fw_uart_read(received.data(), 96, &view, &used) == FW_ERR_VALUE);
    }
    for (const std::uint16_t label : {2, 7}) {
        fw_uart_packet lie = packet();
        lie.label = label;
        Bytes out(96, 0xEE);
        CHECK(fw_uart_write(&lie, out.data(), 96) == FW_ERR_VALUE);
        Bytes received = written(packet());
        received[68] = static_cast<std::uint8_t>(label);
        CHECK(fw_uart_read(received.data(), 96, &view, &used) == FW_ERR_VALUE);
    }
}
