#include "sim/core/random.hpp"

#include <Random123/philox.h>

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/core/kernels.hpp"

namespace specula {

namespace {

/// FNV-1a, 32 bit: names a purpose by a number.
constexpr std::uint32_t hash(std::string_view text) {
    std::uint32_t h = 2166136261u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 16777619u;
    return h;
}

}  // namespace

Stream::Stream(const StreamKey& key)
    : key_{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)},
      counter_{0, key.item, key.world, hash(key.purpose)} {}

void Stream::refill() {
    const r123::Philox4x32 philox;  // ten rounds
    const auto block =
        philox({{counter_[0], counter_[1], counter_[2], counter_[3]}}, {{key_[0], key_[1]}});
    for (std::size_t i = 0; i < 4; ++i) block_[i] = block[i];
    ++counter_[0];
    used_ = 0;
}

std::uint32_t Stream::bits() {
    if (used_ == 4) refill();
    return block_[static_cast<std::size_t>(used_++)];
}

double Stream::uniform() {
    return (bits() + 0.5) * 0x1p-32;
}

void Stream::fill_bits(std::span<std::uint32_t> words) {
    std::size_t i = 0;
    while (i < words.size() && used_ < 4) words[i++] = bits();
    for (; i + 4 <= words.size(); i += 4) {
        refill();
        std::copy(block_.begin(), block_.end(), words.begin() + static_cast<std::ptrdiff_t>(i));
        used_ = 4;
    }
    while (i < words.size()) words[i++] = bits();
}

double Stream::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_normal_;
    }
    const std::uint32_t words[2] = {bits(), bits()};
    double pair[2];
    kernels().normals(words, 1, pair);
    spare_normal_ = pair[1];
    has_spare_ = true;
    return pair[0];
}

std::uint32_t Stream::below(std::uint32_t n) {
    SPECULA_EXPECT(n > 0);
    return static_cast<std::uint32_t>((std::uint64_t{bits()} * n) >> 32);
}

void Stream::fill_normal(std::span<double> values) {
    constexpr std::size_t most_pairs = 128;
    std::array<std::uint32_t, 2 * most_pairs> words;
    std::size_t i = 0;
    if (has_spare_ && !values.empty()) values[i++] = normal();
    while (i + 2 <= values.size()) {
        const std::size_t n_pairs = std::min(most_pairs, (values.size() - i) / 2);
        fill_bits(std::span(words).first(2 * n_pairs));
        kernels().normals(words.data(), n_pairs, &values[i]);
        i += 2 * n_pairs;
    }
    if (i < values.size()) values[i] = normal();
}

}  // namespace specula
