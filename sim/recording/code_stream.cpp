#include "sim/recording/code_stream.hpp"

#include <array>

namespace specula {

namespace {

constexpr std::size_t group_words = 4;
constexpr int code_bits = 12;

using Group = std::array<std::uint16_t, group_words>;

std::size_t word_of(int bit) {
    return static_cast<std::size_t>(bit % 4);
}
int shift_of(std::size_t code, int bit) {
    return 9 - 3 * static_cast<int>(code) + bit / 4;
}

std::int16_t sign_extended(unsigned bits) {
    const int value = static_cast<int>(bits);
    return static_cast<std::int16_t>(value >= 1 << (code_bits - 1) ? value - (1 << code_bits)
                                                                   : value);
}

Group unswizzled(const Group& words) {
    Group codes{};
    for (std::size_t j = 0; j < group_words; ++j) {
        unsigned bits = 0;
        for (int i = 0; i < code_bits; ++i)
            bits |= ((static_cast<unsigned>(words[word_of(i)]) >> shift_of(j, i)) & 1u) << i;
        codes[j] = static_cast<std::uint16_t>(sign_extended(bits));
    }
    return codes;
}

Group swizzled(const Group& codes) {
    Group words{};
    for (std::size_t j = 0; j < group_words; ++j)
        for (int i = 0; i < code_bits; ++i) {
            const unsigned bit = (static_cast<unsigned>(codes[j]) >> i) & 1u;
            words[word_of(i)] =
                static_cast<std::uint16_t>(words[word_of(i)] | (bit << shift_of(j, i)));
        }
    return words;
}

Group with_middle_swapped(const Group& words) {
    return {words[0], words[2], words[1], words[3]};
}

void check_words(const Group& words, std::size_t offset) {
    for (std::size_t k = 0; k < group_words; ++k)
        if (words[k] >> code_bits != 0)
            fail_at(offset + 2 * k,
                    format("the word {:#06x} has bits beyond its {}", words[k], code_bits),
                    "this is no stream of RDIF swizzle mode 2; use another packing");
}

void check_codes(const Group& codes, std::size_t first) {
    constexpr int bound = 1 << (code_bits - 1);
    for (std::size_t k = 0; k < group_words; ++k) {
        const int code = static_cast<std::int16_t>(codes[k]);
        if (code < -bound || code >= bound)
            throw InputError(format("code {} = {}: does not fit into {} bits; use another format",
                                    first + k, code, code_bits));
    }
}

}  // namespace

std::vector<std::int16_t> unpack_codes(Bytes bytes, Packing packing) {
    const std::size_t group_bytes = packing == Packing::int16 ? 2 : 2 * group_words;
    if (const std::size_t rest = bytes.size() % group_bytes; rest != 0)
        fail_at(bytes.size() - rest, format("{} of {} bytes are left", rest, group_bytes),
                "is the stream whole, and this its packing?");
    std::vector<std::int16_t> codes(bytes.size() / 2);
    if (packing == Packing::int16) {
        for (std::size_t i = 0; i < codes.size(); ++i)
            codes[i] = static_cast<std::int16_t>(u16_at(bytes, 2 * i, "a code"));
        return codes;
    }
    for (std::size_t first = 0; first < codes.size(); first += group_words) {
        Group words;
        for (std::size_t k = 0; k < group_words; ++k)
            words[k] = u16_at(bytes, 2 * (first + k), "a group");
        if (packing == Packing::rdif_swizzle_2) check_words(words, 2 * first);
        const Group group =
            packing == Packing::rdif_swizzle_2 ? unswizzled(words) : with_middle_swapped(words);
        for (std::size_t k = 0; k < group_words; ++k)
            codes[first + k] = static_cast<std::int16_t>(group[k]);
    }
    return codes;
}

std::string pack_codes(std::span<const std::int16_t> codes, Packing packing) {
    std::string out;
    out.reserve(2 * codes.size());
    if (packing == Packing::int16) {
        for (const std::int16_t code : codes)
            append_number(out, static_cast<std::uint16_t>(code), 2);
        return out;
    }
    if (codes.size() % group_words != 0)
        throw InputError(format("{} codes are no whole number of groups of {}; use another format",
                                codes.size(), group_words));
    for (std::size_t first = 0; first < codes.size(); first += group_words) {
        Group group;
        for (std::size_t k = 0; k < group_words; ++k)
            group[k] = static_cast<std::uint16_t>(codes[first + k]);
        if (packing == Packing::rdif_swizzle_2) check_codes(group, first);
        group = packing == Packing::rdif_swizzle_2 ? swizzled(group) : with_middle_swapped(group);
        for (const std::uint16_t word : group) append_number(out, word, 2);
    }
    return out;
}

}  // namespace specula
