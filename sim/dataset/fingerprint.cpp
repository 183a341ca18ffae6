#include "sim/dataset/fingerprint.hpp"

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
    for (const std::int16_t code : dataset.adc) {
        const auto bits = static_cast<std::uint16_t>(code);
        hash.add(static_cast<std::uint8_t>(bits & 0xff));
        hash.add(static_cast<std::uint8_t>(bits >> 8));
    }
    for (const Truth& truth : dataset.truth) hash.add(truth.label);
    return format("{:016x}", hash.value());
}

}  // namespace specula
