#include "firmware/fw_injection.h"

#include <cstdint>
#include <vector>

#include "tests/check.hpp"

namespace {

/// A file of two frames of 3 chirps, 2 antennas and 16 samples, each sample telling where it is.
std::vector<std::uint32_t> file(std::vector<std::uint32_t> header = {16, 2, 3, 2}) {
    for (std::uint32_t i = 0; i < 2 * 3 * 2 * 16; i += 2) header.push_back(i | (i + 1) << 16);
    return header;
}

fw_status open(const std::vector<std::uint32_t>& words, fw_injection& injection) {
    return fw_injection_open(words.data(), 4 * words.size(), &injection);
}

}  // namespace

TEST_CASE("injected samples are read as frame, chirp, antenna, sample", "[firmware]") {
    const auto words = file();
    fw_injection injection{};
    REQUIRE(open(words, injection) == FW_OK);
    CHECK(injection.n_frames == 2);
    const fw_frame second = fw_injection_frame(&injection, 1);
    CHECK(second.n_chirps == 3);
    CHECK(second.n_rx == 2);
    CHECK(second.n_samples == 16);
    CHECK(second.samples[0] == 96);
    CHECK(second.samples[(2 * 2 + 1) * 16 + 5] == 96 + 85);
    CHECK(fw_injection_frame(&injection, 2).samples == nullptr);
    CHECK(fw_injection_frame(nullptr, 0).samples == nullptr);
}

TEST_CASE("a file that is not what its counts say is refused", "[firmware]") {
    fw_injection injection{
        .samples = nullptr, .n_samples = 7, .n_rx = 7, .n_chirps = 7, .n_frames = 7};
    auto words = file();
    words.pop_back();
    CHECK(open(words, injection) == FW_ERR_LENGTH);
    CHECK(open(file({16, 2, 3, 3}), injection) == FW_ERR_LENGTH);
    CHECK(open(file({16, 2, 3, 0}), injection) == FW_ERR_SHAPE);
    CHECK(open(file({15, 2, 3, 2}), injection) == FW_ERR_SHAPE);
    CHECK(open(file({1025, 2, 3, 2}), injection) == FW_ERR_SHAPE);
    CHECK(open(file({16, 0, 3, 2}), injection) == FW_ERR_SHAPE);
    CHECK(open(file({16, 2, 65536, 2}), injection) == FW_ERR_SHAPE);
    CHECK(open(file({1024, 65535, 65535, 4294967295}), injection) == FW_ERR_LENGTH);
    CHECK(open({16, 2, 3}, injection) == FW_ERR_LENGTH);
    words = file();
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(words.data());
    CHECK(fw_injection_open(bytes + 2, 100, &injection) == FW_ERR_ALIGNMENT);
    CHECK(fw_injection_open(nullptr, 100, &injection) == FW_ERR_NULL);
    CHECK(injection.n_frames == 7);
}
