#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace specula {

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece; the one door to OpenSSL's libcrypto.
class Sha256 {
  public:
    using Digest = std::array<std::uint8_t, 32>;

    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::span<const std::uint8_t> bytes);
    /// The digest of all that was added; the next byte begins a new message.
    Digest finish();

  private:
    struct State;  ///< hides the library
    std::unique_ptr<State> state_;
};

/// The bytes of numbers as they lie in memory: little-endian on every machine that is supported.
template <typename T>
std::span<const std::uint8_t> bytes_of_values(std::span<const T> values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

/// 64 hexadecimal digits.
std::string hexadecimal(const Sha256::Digest& digest);
std::string sha256_of(std::string_view text);
/// Reads the file once. Throws SystemError naming it.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace specula
