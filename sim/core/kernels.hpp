#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace specula {

/// The loops in which the time goes, compiled once per level of x86-64.
///
/// Eight doubles at a time in the same order on every level, without contraction to fused
/// operations: all levels give the same bits, which a test holds them to, and none depends on the
/// system's libm.
struct Kernels {
    const char* level;  ///< "x86-64", "x86-64-v3" (AVX2) or "x86-64-v4" (AVX-512)

    /// Cosine and sine of 2 pi turns, to 3e-16; |turns| < 2^49.
    void (*turn)(const double* turns, std::size_t n, double* cosine, double* sine);
    /// Two numbers of zero mean and unit variance from two words of 32 random bits (Box and Muller
    /// 1958): the words (pair, 2) become the numbers (pair, 2).
    void (*normals)(const std::uint32_t* words, std::size_t n_pairs, double* numbers);
    /// sums(row, column) += Sum_i rows(i, row) columns(i, column), i one after the other.
    struct Shape {
        std::size_t n;
        std::size_t n_rows;
        std::size_t n_columns;  ///< a multiple of `lanes`
    };
    void (*add_products)(const Shape& shape, const double* rows, const double* columns,
                         double* sums);
    /// The way from one point over each of (x, y, z) to another one.
    struct Ends {
        double from[3];
        double to[3];
    };
    struct Points {
        const double *x, *y, *z;
        std::size_t n;
    };
    void (*paths)(const Points& points, const Ends& ends, double* path);

    static constexpr std::size_t lanes = 8;
    /// The next multiple of `lanes`.
    static constexpr std::size_t padded(std::size_t n) { return (n + lanes - 1) / lanes * lanes; }
};

/// Those of the best level that this machine has.
const Kernels& kernels();

/// Those of every level that this machine has, the lowest first.
std::vector<const Kernels*> all_kernels();

}  // namespace specula
