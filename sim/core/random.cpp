#include "sim/core/random.hpp"

#include <Random123/philox.h>

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

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

double Stream::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_normal_;
    }
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle_rad = two_pi * uniform();
    spare_normal_ = radius * std::sin(angle_rad);
    has_spare_ = true;
    return radius * std::cos(angle_rad);
}

std::uint32_t Stream::below(std::uint32_t n) {
    SPECULA_EXPECT(n > 0);
    return static_cast<std::uint32_t>((std::uint64_t{bits()} * n) >> 32);
}

void Stream::fill_normal(std::span<double> values) {
    for (double& value : values) value = normal();
}

}  // namespace specula
