#pragma once

// The body of the kernels, for the file of one level to include after defining KERNEL_LEVEL.

#include <bit>
#include <cmath>
#include <cstring>

#include "sim/core/kernels.hpp"

namespace specula {

namespace {

constexpr std::size_t n_lanes = Kernels::lanes;
using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));
using LaneBits = long long __attribute__((vector_size(n_lanes * sizeof(long long))));
using LaneWords = std::uint32_t __attribute__((vector_size(n_lanes * sizeof(std::uint32_t))));

inline Lanes load(const double* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
inline void store(const Lanes& lanes, double* to) {
    std::memcpy(to, &lanes, sizeof lanes);
}

/// Adding and taking away 1.5 * 2^52 rounds to the nearest whole number, whose last bits then stand
/// in the sum's.
constexpr double rounder = 6755399441055744.0;

/// Polynomials of fdlibm for sine and cosine on [-pi/4, pi/4] (Sun Microsystems 1993).
inline void turn_lanes(const Lanes& turns, Lanes& cosine, Lanes& sine) {
    constexpr double two_pi = 6.283185307179586476925;
    const Lanes shifted = 4.0 * turns + rounder;
    const LaneBits quarter = std::bit_cast<LaneBits>(shifted);
    const Lanes angle = (turns - 0.25 * (shifted - rounder)) * two_pi;
    const Lanes z = angle * angle;
    const Lanes s =
        angle +
        angle * z *
            (-1.66666666666666324348e-01 +
             z * (8.33333333332248946124e-03 +
                  z * (-1.98412698298579493134e-04 +
                       z * (2.75573137070700676789e-06 +
                            z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
    const Lanes c =
        1.0 - 0.5 * z +
        z * z *
            (4.16666666666666019037e-02 +
             z * (-1.38888888888741095749e-03 +
                  z * (2.48015872894767294178e-05 +
                       z * (-2.75573143513906633035e-07 +
                            z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
    const LaneBits swapped = -(quarter & 1);
    const LaneBits s_bits = std::bit_cast<LaneBits>(s);
    const LaneBits c_bits = std::bit_cast<LaneBits>(c);
    const LaneBits cosine_bits =
        ((c_bits & ~swapped) | (s_bits & swapped)) ^ (((quarter + 1) & 2) << 62);
    const LaneBits sine_bits = ((s_bits & ~swapped) | (c_bits & swapped)) ^ ((quarter & 2) << 62);
    cosine = std::bit_cast<Lanes>(cosine_bits);
    sine = std::bit_cast<Lanes>(sine_bits);
}

/// Natural logarithm of positive normal numbers, after fdlibm's e_log.c.
inline Lanes log_lanes(const Lanes& x) {
    constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
    constexpr long long half_root = 0x3fe6a09e667f3bcd;  // sqrt(1/2): mantissas run from there
    const LaneBits bits = std::bit_cast<LaneBits>(x);
    const LaneBits exponent = (bits - half_root) >> 52;
    const LaneBits mantissa_bits = bits - (exponent << 52);
    const LaneBits exponent_bits = exponent + 0x4338000000000000;  // `rounder` plus the exponent
    const Lanes e = std::bit_cast<Lanes>(exponent_bits) - rounder;
    const Lanes f = std::bit_cast<Lanes>(mantissa_bits) - 1.0;
    const Lanes s = f / (2.0 + f), z = s * s;
    const Lanes rest =
        z * (6.666666666666735130e-01 +
             z * (3.999999999940941908e-01 +
                  z * (2.857142874366239149e-01 +
                       z * (2.222219843214978396e-01 +
                            z * (1.818357216161805012e-01 +
                                 z * (1.531383769920937332e-01 + z * 1.479819860511658591e-01))))));
    const Lanes half_square = 0.5 * f * f;
    return e * ln2_high - ((half_square - (s * (half_square + rest) + e * ln2_low)) - f);
}

inline Lanes root_lanes(Lanes x) {
    for (std::size_t i = 0; i < n_lanes; ++i) x[i] = std::sqrt(x[i]);
    return x;
}

void turn(const double* turns, std::size_t n, double* cosine, double* sine) {
    Lanes c, s;
    std::size_t i = 0;
    for (; i + n_lanes <= n; i += n_lanes) {
        turn_lanes(load(turns + i), c, s);
        store(c, cosine + i);
        store(s, sine + i);
    }
    if (i == n) return;
    Lanes rest{};
    std::memcpy(&rest, turns + i, (n - i) * sizeof(double));
    turn_lanes(rest, c, s);
    std::memcpy(cosine + i, &c, (n - i) * sizeof(double));
    std::memcpy(sine + i, &s, (n - i) * sizeof(double));
}

/// Words as numbers in the open interval (0, 1).
inline Lanes uniform_lanes(const std::uint32_t* words) {
    LaneWords whole;
    std::memcpy(&whole, words, sizeof whole);
    const LaneBits bits = __builtin_convertvector(whole, LaneBits) | 0x4330000000000000;  // 2^52
    return (std::bit_cast<Lanes>(bits) - 4503599627370496.0 + 0.5) * 0x1p-32;
}

void normals(const std::uint32_t* words, std::size_t n_pairs, double* numbers) {
    for (std::size_t first = 0; first < n_pairs; first += n_lanes) {
        const std::size_t n = first + n_lanes <= n_pairs ? n_lanes : n_pairs - first;
        std::uint32_t length[n_lanes] = {}, angle[n_lanes] = {};
        for (std::size_t i = 0; i < n; ++i) {
            length[i] = words[2 * (first + i)];
            angle[i] = words[2 * (first + i) + 1];
        }
        const Lanes radius = root_lanes(-2.0 * log_lanes(uniform_lanes(length)));
        Lanes c, s;
        turn_lanes(uniform_lanes(angle), c, s);
        c *= radius;
        s *= radius;
        for (std::size_t i = 0; i < n; ++i) {
            numbers[2 * (first + i)] = c[i];
            numbers[2 * (first + i) + 1] = s[i];
        }
    }
}

/// Lanes as wide as the level's registers: the compiler keeps these there, and not in memory.
#if defined(__AVX512F__)
constexpr std::size_t kept_lanes = 8;
#elif defined(__AVX__)
constexpr std::size_t kept_lanes = 4;
#else
constexpr std::size_t kept_lanes = 2;
#endif
using KeptLanes = double __attribute__((vector_size(kept_lanes * sizeof(double))));

/// Some rows and one block of columns, kept in registers from the first i to the last.
template <std::size_t n_kept>
inline void add_block(const Kernels::Shape& shape, const double* rows, const double* columns,
                      double* sums) {
    KeptLanes kept[n_kept];
    for (std::size_t r = 0; r < n_kept; ++r)
        std::memcpy(&kept[r], sums + r * shape.n_columns, sizeof kept[r]);
    for (std::size_t i = 0; i < shape.n; ++i) {
        KeptLanes column;
        std::memcpy(&column, columns + i * shape.n_columns, sizeof column);
        for (std::size_t r = 0; r < n_kept; ++r) kept[r] += rows[i * shape.n_rows + r] * column;
    }
    for (std::size_t r = 0; r < n_kept; ++r)
        std::memcpy(sums + r * shape.n_columns, &kept[r], sizeof kept[r]);
}

/// As many rows as are left over, fewer than n_most + 1.
template <std::size_t n_most>
inline void add_rest(std::size_t n_left, const Kernels::Shape& shape, const double* rows,
                     const double* columns, double* sums) {
    if (n_left == n_most) return add_block<n_most>(shape, rows, columns, sums);
    if constexpr (n_most > 1) add_rest<n_most - 1>(n_left, shape, rows, columns, sums);
}

void add_products(const Kernels::Shape& shape, const double* rows, const double* columns,
                  double* sums) {
    constexpr std::size_t at_once = 8;
    for (std::size_t c = 0; c < shape.n_columns; c += kept_lanes) {
        std::size_t r = 0;
        for (; r + at_once <= shape.n_rows; r += at_once)
            add_block<at_once>(shape, rows + r, columns + c, sums + r * shape.n_columns + c);
        add_rest<at_once - 1>(shape.n_rows - r, shape, rows + r, columns + c,
                              sums + r * shape.n_columns + c);
    }
}

inline Lanes distances(const double* x, const double* y, const double* z, const double* from) {
    const Lanes dx = load(x) - from[0], dy = load(y) - from[1], dz = load(z) - from[2];
    return root_lanes(dx * dx + dy * dy + dz * dz);
}

void paths(const Kernels::Points& points, const Kernels::Ends& ends, double* path) {
    const auto& [x, y, z, n] = points;
    std::size_t i = 0;
    for (; i + n_lanes <= n; i += n_lanes)
        store(distances(x + i, y + i, z + i, ends.from) + distances(x + i, y + i, z + i, ends.to),
              path + i);
    for (; i < n; ++i) {
        double sum = 0.0;
        for (const double* end : {ends.from, ends.to}) {
            const double dx = x[i] - end[0], dy = y[i] - end[1], dz = z[i] - end[2];
            sum += std::sqrt(dx * dx + dy * dy + dz * dz);
        }
        path[i] = sum;
    }
}

}  // namespace

}  // namespace specula
