#include "firmware/fw_crc32.h"

#include <cstdint>
#include <string>
#include <vector>

#include "tests/check.hpp"

namespace {

std::uint32_t crc(const std::vector<std::uint8_t>& bytes) {
    return fw_crc32(bytes.data(), bytes.size());
}

/// The definition: polynomial division, one bit after the other.
std::uint32_t plainly(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t remainder = 0xFFFFFFFF;
    for (const auto byte : bytes) {
        for (int bit = 0; bit < 8; ++bit) {
            const bool odd = ((remainder ^ static_cast<std::uint32_t>(byte >> bit)) & 1) != 0;
            remainder = (remainder >> 1) ^ (odd ? 0xEDB88320U : 0);
        }
    }
    return ~remainder;
}

}  // namespace

TEST_CASE("the checksum is the CRC-32 of zlib and Ethernet", "[firmware]") {
    const std::string digits = "123456789";
    CHECK(crc({digits.begin(), digits.end()}) == 0xCBF43926);
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 600; ++i) {
        CHECK(crc(bytes) == plainly(bytes));
        bytes.push_back(static_cast<std::uint8_t>(i * i + 7));
    }
    CHECK(fw_crc32(nullptr, 4) == 0);
}

TEST_CASE("the checksum notices every single wrong bit", "[firmware]") {
    std::vector<std::uint8_t> bytes(64, 0x5A);
    const auto whole = crc(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        CHECK(crc(bytes) != whole);
        bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    }
}
