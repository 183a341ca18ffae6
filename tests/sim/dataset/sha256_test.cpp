#include "sim/dataset/sha256.hpp"

#include <fstream>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"

namespace specula {
namespace {

// Messages and digests of NIST's examples for FIPS 180-4.
const std::string two_blocks = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
const char* const digest_of_two_blocks =
    "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";

TEST_CASE("SHA-256 gives the digests that NIST publishes", "[dataset]") {
    CHECK(sha256_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256_of(two_blocks) == digest_of_two_blocks);
    CHECK(sha256_of(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a digest does not depend on the pieces, and the next message begins afresh",
          "[dataset]") {
    Sha256 hash;
    for (int round = 0; round < 2; ++round) {
        for (const char letter : two_blocks) hash.add(bytes_of_values(std::span(&letter, 1)));
        CHECK(hexadecimal(hash.finish()) == digest_of_two_blocks);
    }
}

TEST_CASE("a file's digest is that of its bytes, and a missing file is named", "[dataset]") {
    const TemporaryFolder folder;
    std::string content;
    for (int i = 0; content.size() < 700'000; ++i) content += std::to_string(i);
    std::ofstream(folder / "a", std::ios::binary) << content;
    CHECK(sha256_of_file(folder / "a") == sha256_of(content));
    CHECK_THROWS_AS(sha256_of_file(folder / "none"), SystemError);
}

}  // namespace
}  // namespace specula
