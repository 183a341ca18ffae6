#include "sim/dataset/sha256.hpp"

#include <openssl/evp.h>

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

static_assert(std::endian::native == std::endian::little, "hashes are over little-endian numbers");

struct Sha256::State {
    EVP_MD* algorithm = EVP_MD_fetch(nullptr, "SHA256", nullptr);
    EVP_MD_CTX* context = EVP_MD_CTX_new();

    void begin() { SPECULA_EXPECT(EVP_DigestInit_ex2(context, algorithm, nullptr) == 1); }
    ~State() {
        EVP_MD_CTX_free(context);
        EVP_MD_free(algorithm);
    }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
    state_->begin();
}
Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::uint8_t> bytes) {
    SPECULA_EXPECT(EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()) == 1);
}

Sha256::Digest Sha256::finish() {
    Digest digest;
    unsigned size = 0;
    SPECULA_EXPECT(EVP_DigestFinal_ex(state_->context, digest.data(), &size) == 1);
    SPECULA_EXPECT(size == digest.size());
    state_->begin();
    return digest;
}

std::string hexadecimal(const Sha256::Digest& digest) {
    std::string text;
    for (const std::uint8_t byte : digest) text += format("{:02x}", byte);
    return text;
}

std::string sha256_of(std::string_view text) {
    Sha256 hash;
    hash.add(bytes_of_values(std::span(text.data(), text.size())));
    return hexadecimal(hash.finish());
}

std::string sha256_of_file(const std::filesystem::path& file) {
    const auto fail = [&] {
        throw SystemError(file.string() + ": cannot read: " + std::strerror(errno));
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rbe"),
                                                             std::fclose);
    if (!in) fail();
    Sha256 hash;
    std::vector<std::uint8_t> block(1 << 18);
    for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), in.get())) > 0;)
        hash.add({block.data(), n});
    if (std::ferror(in.get())) fail();
    return hexadecimal(hash.finish());
}

}  // namespace specula
