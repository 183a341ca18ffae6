#include "sim/spread_draws.hpp"

#include <array>

#include "sim/core/expect.hpp"
#include "sim/core/random.hpp"

namespace specula {

namespace {

constexpr int n_bits = 32;

/// A primitive polynomial over two elements and where its directions start: S. Joe, F. Y. Kuo,
/// SIAM J. Sci. Comput. 30 (2008), their table new-joe-kuo-6; the first dimension has none.
struct Polynomial {
    unsigned degree, coefficients;
    std::array<std::uint32_t, 5> first;
};
constexpr std::array<Polynomial, SpreadAxis::most_dimensions - 1> polynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
}};

using Directions = std::array<std::uint32_t, n_bits>;

Directions directions_of(int dimension) {
    Directions v{};
    if (dimension == 0) {
        for (unsigned i = 0; i < n_bits; ++i) v[i] = 1u << (n_bits - 1 - i);
        return v;
    }
    const Polynomial& p = polynomials[static_cast<std::size_t>(dimension - 1)];
    for (unsigned i = 0; i < n_bits; ++i) {
        if (i < p.degree) {
            v[i] = p.first[i] << (n_bits - 1 - i);
            continue;
        }
        v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
        for (unsigned k = 1; k < p.degree; ++k)
            if ((p.coefficients >> (p.degree - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

double centre_of(std::uint32_t digits) {
    return (digits + 0.5) * 0x1p-32;
}

Stream stream_of(const SpreadItem& item, const SpreadAxis& axis, std::uint32_t index) {
    return Stream({.seed = item.seed, .purpose = axis.name, .world = item.group, .item = index});
}

/// The digital shift of an axis, the same for all items of a group; index 2^32 - 1 is no item's.
std::uint32_t shift_of(const SpreadItem& item, const SpreadAxis& axis) {
    return stream_of(item, axis, 0xffffffffu).bits();
}

double sobol(const SpreadItem& item, const SpreadAxis& axis) {
    const Directions v = directions_of(axis.dimension);
    std::uint32_t digits = shift_of(item, axis);
    for (unsigned i = 0; item.index >> i != 0; ++i)
        if ((item.index >> i) & 1u) digits ^= v[i];
    return centre_of(digits);
}

/// Finalizer of MurmurHash3 (A. Appleby, public domain): every bit depends on every other.
std::uint32_t mixed(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return x ^ (x >> 16);
}

/// A permutation of [0, n) drawn for the axis: a Feistel network over the next power of four,
/// walked until it comes back into the interval.
std::uint32_t permuted(const SpreadItem& item, const SpreadAxis& axis) {
    unsigned half = 1;
    while (half < 16 && (std::uint64_t{1} << (2 * half)) < item.n) ++half;
    const std::uint32_t mask = (1u << half) - 1u;
    std::array<std::uint32_t, 6> keys{};
    Stream stream = stream_of(item, axis, 0xfffffffeu);
    for (std::uint32_t& key : keys) key = stream.bits();
    std::uint32_t value = item.index;
    do {
        std::uint32_t high = value >> half, low = value & mask;
        for (const std::uint32_t key : keys) {
            const std::uint32_t next = high ^ (mixed(low ^ key) & mask);
            high = low;
            low = next;
        }
        value = high << half | low;
    } while (value >= item.n);
    return value;
}

}  // namespace

double spread_uniform(const SpreadItem& item, const SpreadAxis& axis, Sampling sampling) {
    SPECULA_EXPECT(item.index < item.n);
    SPECULA_EXPECT(axis.dimension >= 0 && axis.dimension < SpreadAxis::most_dimensions);
    if (sampling == Sampling::quasi) return sobol(item, axis);
    const double u = stream_of(item, axis, item.index).uniform();
    if (sampling == Sampling::stratified) return (permuted(item, axis) + u) / item.n;
    return u;
}

}  // namespace specula
