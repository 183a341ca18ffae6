#include "sim/dataset/fingerprint.hpp"

#include <bit>

#include "sim/core/format.hpp"

namespace specula {

namespace {

class Fnv1a {
  public:
    void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 1099511628211ull; }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 14695981039346656037ull;
};

}  // namespace

std::string fingerprint(const Dataset& dataset) {
    Fnv1a hash;
    const auto add = [&hash](std::uint64_t bits, int n_bytes) {
        for (int i = 0; i < n_bytes; ++i) hash.add(static_cast<std::uint8_t>(bits >> (8 * i)));
    };
    for (const std::int16_t code : dataset.adc) add(static_cast<std::uint16_t>(code), 2);
    for (const std::int16_t code : dataset.adc_quadrature) add(static_cast<std::uint16_t>(code), 2);
    for (const double value : dataset.features) add(std::bit_cast<std::uint64_t>(value), 8);
    for (const Truth& truth : dataset.truth) hash.add(truth.label);
    return format("{:016x}", hash.value());
}

}  // namespace specula
