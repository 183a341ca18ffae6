#include "sim/dataset/chunk_packer.hpp"

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

std::vector<std::int16_t> some_codes(std::size_t n) {
    Stream stream({.seed = 3, .purpose = "codes"});
    std::vector<std::int16_t> codes;
    for (std::size_t i = 0; i < n; ++i)
        codes.push_back(static_cast<std::int16_t>(300.0 * stream.normal()));
    codes.front() = -32768;
    codes.back() = 32767;
    return codes;
}

TEST_CASE("a chunk unpacks to the codes that it was packed from", "[dataset]") {
    ChunkPacker packer;
    ChunkUnpacker unpacker;
    for (const std::size_t n :
         {std::size_t{1}, std::size_t{2}, std::size_t{384}, std::size_t{4099}}) {
        const std::vector<std::int16_t> codes = some_codes(n);
        PackedFrames packed;
        packer.add(codes, packed);
        std::vector<std::int16_t> found(n);
        REQUIRE(unpacker.unpack(packed.chunk(0), found));
        CHECK(found == codes);
    }
}

TEST_CASE("a damaged chunk or one of another length is not unpacked", "[dataset]") {
    ChunkPacker packer;
    ChunkUnpacker unpacker;
    PackedFrames packed;
    packer.add(some_codes(40), packed);
    std::vector<std::int16_t> found(40), fewer(39), more(41);
    for (std::size_t i = 0; i < packed.bytes.size(); ++i) {
        std::vector<std::uint8_t> damaged = packed.bytes;
        damaged[i] ^= 0x10;
        CHECK_FALSE(unpacker.unpack(damaged, found));
        CHECK_FALSE(unpacker.unpack(std::span(packed.bytes).first(i), found));
    }
    CHECK_FALSE(unpacker.unpack(packed.bytes, fewer));
    CHECK_FALSE(unpacker.unpack(packed.bytes, more));
}

}  // namespace
}  // namespace specula
