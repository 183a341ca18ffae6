#include "sim/core/kernels.hpp"

#include <cmath>
#include <cstring>

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

std::vector<double> uniform_numbers(std::size_t n, double low, double high) {
    Stream stream({.seed = 3, .purpose = "kernels"});
    std::vector<double> numbers(n);
    for (double& number : numbers) number = low + (high - low) * stream.uniform();
    return numbers;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

/// The results of all kernels on numbers that end in the middle of a block.
std::vector<double> results_of(const Kernels& level) {
    constexpr std::size_t n = 1003, n_rows = 13, n_columns = 24, n_points = 17;
    const std::vector<double> x = uniform_numbers(n, -300.0, 300.0);
    std::vector<double> all(2 * n);
    level.turn(x.data(), n, all.data(), all.data() + n);
    std::vector<std::uint32_t> words(2 * n);
    Stream stream({.seed = 4, .purpose = "kernels"});
    for (std::uint32_t& word : words) word = stream.bits();
    words[0] = 0;
    words[2] = ~0u;
    std::vector<double> normal(2 * n), path(n), sums(n_rows * n_columns);
    level.normals(words.data(), n, normal.data());
    level.paths({x.data(), all.data(), all.data() + n, n}, {{0.1, 0.2, 0.3}, {-1.0, 0.0, 2.0}},
                path.data());
    level.add_products({n_points, n_rows, n_columns}, x.data(), all.data(), sums.data());
    for (const auto* more : {&normal, &path, &sums})
        all.insert(all.end(), more->begin(), more->end());
    return all;
}

TEST_CASE("every level of the machine computes the same bits", "[core][kernels]") {
    const auto levels = all_kernels();
    REQUIRE(levels.front()->level == std::string("x86-64"));
    CHECK(&kernels() == levels.back());
    const std::vector<double> lowest = results_of(*levels.front());
    for (const Kernels* level : levels) {
        INFO(level->level);
        CHECK(same_bits(results_of(*level), lowest));
    }
}

TEST_CASE("cosine and sine are those of the C library in longer arithmetic", "[core][kernels]") {
    const std::vector<double> turns = uniform_numbers(4001, -1000.0, 1000.0);
    std::vector<double> cosine(turns.size()), sine(turns.size());
    kernels().turn(turns.data(), turns.size(), cosine.data(), sine.data());
    double worst = 0.0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const long double angle = 2.0L * 3.141592653589793238462643L *
                                  (static_cast<long double>(turns[i]) - std::floor(turns[i]));
        worst = std::max(worst, static_cast<double>(std::abs(cosine[i] - std::cos(angle))));
        worst = std::max(worst, static_cast<double>(std::abs(sine[i] - std::sin(angle))));
    }
    CHECK(worst < 3e-16);  // as promised: one and a half units in the last place of 1
}

TEST_CASE("normal numbers in blocks are Box and Muller's, extreme words included",
          "[core][kernels]") {
    std::vector<std::uint32_t> words{0, 0, ~0u, ~0u, 1, 1u << 31, 12345, 1u << 30};
    std::vector<double> normal(words.size());
    kernels().normals(words.data(), words.size() / 2, normal.data());
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const double radius = std::sqrt(-2.0 * std::log((words[i] + 0.5) * 0x1p-32));
        const double angle_rad = two_pi * ((words[i + 1] + 0.5) * 0x1p-32);
        CHECK(std::abs(normal[i] - radius * std::cos(angle_rad)) < 1e-14);  // of up to 6.7
        CHECK(std::abs(normal[i + 1] - radius * std::sin(angle_rad)) < 1e-14);
    }
}

TEST_CASE("normal numbers are the same one by one and in blocks of any length", "[core][kernels]") {
    for (const std::size_t first : {0u, 1u, 2u, 7u})
        for (const std::size_t n : {0u, 1u, 2u, 255u, 256u, 257u, 600u}) {
            Stream singly({.seed = 5, .purpose = "normal"}), many({.seed = 5, .purpose = "normal"});
            std::vector<double> one_by_one, in_a_block(n);
            for (std::size_t i = 0; i < first; ++i) {
                singly.normal();
                many.normal();
            }
            for (std::size_t i = 0; i < n; ++i) one_by_one.push_back(singly.normal());
            many.fill_normal(in_a_block);
            CHECK(one_by_one == in_a_block);
            CHECK(singly.normal() == many.normal());  // and both go on alike
            CHECK(singly.bits() == many.bits());
        }
}

TEST_CASE("sums of products and paths are what loops make of them", "[core][kernels]") {
    constexpr std::size_t n = 9, n_rows = 11, n_columns = 16;
    const std::vector<double> rows = uniform_numbers(n * n_rows, -1.0, 1.0);
    const std::vector<double> columns = uniform_numbers(n * n_columns, -1.0, 1.0);
    std::vector<double> sums(n_rows * n_columns, 0.5);
    kernels().add_products({n, n_rows, n_columns}, rows.data(), columns.data(), sums.data());
    double worst = 0.0;
    for (std::size_t r = 0; r < n_rows; ++r)
        for (std::size_t c = 0; c < n_columns; ++c) {
            double sum = 0.5;
            for (std::size_t i = 0; i < n; ++i)
                sum += rows[i * n_rows + r] * columns[i * n_columns + c];
            worst = std::max(worst, std::abs(sums[r * n_columns + c] - sum));
        }
    CHECK(worst == 0.0);  // the same order

    const double x[] = {3.0}, y[] = {4.0}, z[] = {0.0};
    double path = 0.0;
    kernels().paths({x, y, z, 1}, {{0.0, 0.0, 0.0}, {3.0, 4.0, 12.0}}, &path);
    CHECK(path == 5.0 + 12.0);
}

}  // namespace
}  // namespace specula
