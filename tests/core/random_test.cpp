#include "sim/core/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <set>
#include <vector>

#include "sim/core/expect.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

// FNV-1a of 32 bits, from its authors' test vectors (isthe.com/chongo/tech/comp/fnv).
constexpr const char* purpose_hashed_to_zero = "\xcc\x24\x31\xc4";
constexpr std::uint32_t fnv_of_a = 0xe40c292cu, fnv_of_foobar = 0xbf9cf968u;

std::vector<std::uint32_t> first_bits(const StreamKey& key, std::size_t n) {
    Stream stream(key);
    std::vector<std::uint32_t> bits(n);
    for (std::uint32_t& word : bits) word = stream.bits();
    return bits;
}

TEST_CASE("a key of zeros gives the published test vector of Philox4x32-10", "[random]") {
    // Random123's kat_vectors: counter 0, key 0.
    CHECK(first_bits({.seed = 0, .purpose = purpose_hashed_to_zero}, 4) ==
          std::vector<std::uint32_t>{0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u});
}

TEST_CASE("a stream is Philox of (number, item, world, hash of the purpose) under the seed",
          "[random]") {
    struct Case {
        StreamKey key;
        std::uint32_t hash;
    };
    const Case cases[]{
        {{.seed = 0x0123456789abcdefu, .purpose = "a", .world = 7, .item = 0xfedcba98u}, fnv_of_a},
        {{.seed = ~std::uint64_t{0}, .purpose = "foobar", .world = ~0u, .item = 0}, fnv_of_foobar},
    };
    for (const auto& [key, hash] : cases) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t number = 0; number < 5; ++number) {
            const auto block = r123::Philox4x32()(
                {{number, key.item, key.world, hash}},
                {{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}});
            for (std::size_t i = 0; i < 4; ++i) expected.push_back(block[i]);
        }
        CHECK(first_bits(key, expected.size()) == expected);
    }
}

TEST_CASE("keys that differ in one part give streams that share nothing", "[random]") {
    const StreamKey key{.seed = 7, .purpose = "noise", .world = 1, .item = 2};
    std::vector<StreamKey> keys(7, key);
    keys[1].seed = 8;
    keys[2].seed += std::uint64_t{1} << 32;
    keys[3].purpose = "noisf";
    keys[4].world = 2;
    keys[5].item = 3;
    keys[6].world = 2, keys[6].item = 1;
    std::set<std::uint32_t> seen;
    for (const StreamKey& each : keys)
        for (const std::uint32_t word : first_bits(each, 100)) seen.insert(word);
    CHECK(seen.size() == 700);  // two of 700 words of 32 bits meet with probability 6e-5
}

TEST_CASE("what one stream gives does not depend on draws from another", "[random]") {
    const StreamKey keys[]{{.seed = 1, .purpose = "a"}, {.seed = 1, .purpose = "b"}};
    Stream alone(keys[0]), taken_in_turn(keys[0]), other(keys[1]);
    for (int i = 0; i < 50; ++i) {
        CHECK(alone.normal() == taken_in_turn.normal());
        for (int j = 0; j < i; ++j) (void)other.normal();
    }
}

TEST_CASE("uniform numbers are the middles of 2^32 equal parts of (0, 1)", "[random]") {
    const StreamKey key{.seed = 5, .purpose = "uniform"};
    Stream stream(key);
    for (const std::uint32_t word : first_bits(key, 1000))
        CHECK(stream.uniform() == (static_cast<double>(word) + 0.5) / 4294967296.0);
    // So the least and the greatest are these, and a logarithm of either is finite.
    CHECK((0.0 + 0.5) / 4294967296.0 > 0.0);
    CHECK((4294967295.0 + 0.5) / 4294967296.0 < 1.0);
}

TEST_CASE("uniform numbers have the moments of the uniform law", "[random]") {
    constexpr int n = 200'000;
    Stream stream({.seed = 1, .purpose = "moments"});
    double sum = 0.0, squares = 0.0, products = 0.0, before = 0.5;
    for (int i = 0; i < n; ++i) {
        const double u = stream.uniform() - 0.5;
        sum += u;
        squares += u * u;
        products += u * before;
        before = u;
    }
    // Five standard errors each: of the mean, the variance (kurtosis 1.8), the serial covariance.
    CHECK(std::abs(sum / n) < 5.0 * std::sqrt(1.0 / 12.0 / n));
    CHECK(std::abs(squares / n - 1.0 / 12.0) < 5.0 * std::sqrt(0.8 / n) / 12.0);
    CHECK(std::abs(products / n) < 5.0 / 12.0 / std::sqrt(n));
}

TEST_CASE("normal numbers have the moments and the tails of the normal law", "[random]") {
    constexpr int n = 400'000;
    Stream stream({.seed = 1, .purpose = "moments"});
    double m1 = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0, products = 0.0, before = 0.0;
    int beyond_two = 0;
    for (int i = 0; i < n; ++i) {
        const double z = stream.normal();
        m1 += z / n;
        m2 += z * z / n;
        m3 += z * z * z / n;
        m4 += z * z * z * z / n;
        products += z * before / n;  // the two numbers of one Box-Muller draw are neighbours
        before = z;
        beyond_two += std::abs(z) > 2.0;
    }
    // Five standard errors each: sqrt(Var z^k / n) with Var z = 1, z^2 = 2, z^3 = 15, z^4 = 96.
    CHECK(std::abs(m1) < 5.0 * std::sqrt(1.0 / n));
    CHECK(std::abs(m2 - 1.0) < 5.0 * std::sqrt(2.0 / n));
    CHECK(std::abs(m3) < 5.0 * std::sqrt(15.0 / n));
    CHECK(std::abs(m4 - 3.0) < 5.0 * std::sqrt(96.0 / n));
    CHECK(std::abs(products) < 5.0 * std::sqrt(1.0 / n));
    const double share = std::erfc(2.0 / std::sqrt(2.0));
    CHECK(std::abs(static_cast<double>(beyond_two) / n - share) < 5.0 * std::sqrt(share / n));
}

TEST_CASE("a filled span holds the numbers that single draws give", "[random]") {
    const StreamKey key{.seed = 3, .purpose = "span"};
    Stream filled(key), single(key);
    std::vector<double> values(7);
    filled.fill_normal(values);
    for (const double value : values) CHECK(value == single.normal());
    CHECK(filled.normal() == single.normal());
}

TEST_CASE("an integer below n takes every value equally often and never n", "[random]") {
    constexpr std::uint32_t n = 6;
    constexpr int draws = 60'000;
    Stream stream({.seed = 9, .purpose = "dice"});
    std::vector<int> count(n, 0);
    for (int i = 0; i < draws; ++i) ++count.at(stream.below(n));
    double chi_squared = 0.0;
    for (const int c : count) chi_squared += std::pow(c - 1e4, 2) / 1e4;
    CHECK(chi_squared < 25.7);  // 5 degrees of freedom, exceeded with probability 1e-4

    CHECK(stream.below(1) == 0);
    CHECK_THROWS_AS(stream.below(0), BrokenPromise);
    std::uint32_t most = 0;
    for (int i = 0; i < 1000; ++i) most = std::max(most, stream.below(0xffffffffu));
    CHECK(most > 0xf0000000u);
}

}  // namespace
}  // namespace specula
