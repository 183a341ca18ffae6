#include "sim/recording/code_stream.hpp"

#include "sim/core/random.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::vector<std::int16_t> random_codes(std::size_t n, int bits) {
    Stream stream({.seed = 3, .purpose = "codes"});
    std::vector<std::int16_t> codes;
    for (std::size_t i = 0; i < n; ++i)
        codes.push_back(static_cast<std::int16_t>(static_cast<int>(stream.below(1u << bits)) -
                                                  (1 << (bits - 1))));
    return codes;
}

std::string words(const std::vector<unsigned>& values) {
    std::string bytes;
    for (const unsigned value : values) append_number(bytes, value, 2);
    return bytes;
}

TEST_CASE("codes come back from every packing bit by bit", "[recording]") {
    for (const Packing packing : {Packing::int16, Packing::rdif_swizzle_2, Packing::lvds_iq}) {
        const auto codes = random_codes(4096, packing == Packing::rdif_swizzle_2 ? 12 : 16);
        const std::string bytes = pack_codes(codes, packing);
        CHECK(bytes.size() == 2 * codes.size());
        CHECK(unpack_codes(bytes_in(bytes), packing) == codes);
    }
}

TEST_CASE("bits of an RDIF group lie where the chip puts them", "[recording]") {
    // Bit i of code j is bit 9 - 3 j + i / 4 of word i mod 4: written out for single bits by hand.
    struct Bit {
        std::size_t word;
        int bit;
        std::size_t code;
        int place;
    };
    for (const Bit& b : {Bit{0, 9, 0, 0}, Bit{1, 9, 0, 1}, Bit{3, 10, 0, 7}, Bit{0, 6, 1, 0},
                         Bit{2, 7, 1, 6}, Bit{3, 3, 2, 3}, Bit{0, 0, 3, 0}, Bit{2, 2, 3, 10}}) {
        std::vector<unsigned> group(4, 0);
        group[b.word] = 1u << b.bit;
        std::vector<std::int16_t> expected(4, 0);
        expected[b.code] = static_cast<std::int16_t>(1 << b.place);
        CHECK(unpack_codes(bytes_in(words(group)), Packing::rdif_swizzle_2) == expected);
    }
    // Bit 11 is the sign: -2048.
    CHECK(unpack_codes(bytes_in(words({0, 0, 0, 1u << 11})), Packing::rdif_swizzle_2) ==
          std::vector<std::int16_t>{-2048, 0, 0, 0});
    CHECK(unpack_codes(bytes_in(words({0xfff, 0xfff, 0xfff, 0xfff})), Packing::rdif_swizzle_2) ==
          std::vector<std::int16_t>(4, -1));
}

TEST_CASE("two LVDS lanes carry I0 I1 Q0 Q1", "[recording]") {
    CHECK(unpack_codes(bytes_in(words({1, 2, 10, 20, 3, 4, 30, 40})), Packing::lvds_iq) ==
          std::vector<std::int16_t>{1, 10, 2, 20, 3, 30, 4, 40});
}

TEST_CASE("a stream that is no stream of its packing is refused with the byte", "[recording]") {
    const auto refusal = [](const std::string& bytes, Packing packing) {
        return message_of([&] { return unpack_codes(bytes_in(bytes), packing); });
    };
    CHECK(refusal("abc", Packing::int16) ==
          "byte 2: 1 of 2 bytes are left; is the stream whole, and this its packing?");
    CHECK(refusal(words({1, 2, 3, 4, 5}), Packing::rdif_swizzle_2) ==
          "byte 8: 2 of 8 bytes are left; is the stream whole, and this its packing?");
    CHECK(refusal(words({1, 2, 3, 4, 5, 0xfff0, 7, 8}), Packing::rdif_swizzle_2) ==
          "byte 10: the word 0xfff0 has bits beyond its 12; this is no stream of RDIF swizzle mode "
          "2; use another packing");
    CHECK(message_of([] {
              return pack_codes(std::vector<std::int16_t>{0, 0, 2048, 0}, Packing::rdif_swizzle_2);
          }) == "code 2 = 2048: does not fit into 12 bits; use another format");
}

}  // namespace
}  // namespace specula
