#include "sim/spread_draws.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/check.hpp"

namespace specula {
namespace {

struct Design {
    Sampling sampling;
    std::uint32_t n;
    std::uint32_t group = 0;
    std::uint64_t seed = 5;
};

std::vector<double> draws(const Design& design, int dimension) {
    const std::string name = "axis " + std::to_string(dimension);
    std::vector<double> values;
    for (std::uint32_t i = 0; i < design.n; ++i)
        values.push_back(
            spread_uniform({.seed = design.seed, .group = design.group, .index = i, .n = design.n},
                           {.name = name, .dimension = dimension}, design.sampling));
    return values;
}

/// How many of n equal parts of (0, 1) hold exactly one of n values.
std::size_t filled_parts(const std::vector<double>& values) {
    std::set<std::size_t> parts;
    for (const double value : values)
        parts.insert(static_cast<std::size_t>(value * static_cast<double>(values.size())));
    return parts.size();
}

TEST_CASE("stratified draws put one into each of as many parts as there are", "[sim]") {
    for (const std::uint32_t n : {1u, 2u, 7u, 64u, 1000u}) {
        const auto values = draws({Sampling::stratified, n}, 0);
        CHECK(filled_parts(values) == n);
    }
    // Random ones leave a share 1/e of the parts empty: 368 of 1000, sd 10 of them.
    const auto random = draws({Sampling::random, 1000}, 0);
    CHECK(std::abs(static_cast<double>(filled_parts(random)) - 632.0) < 50.0);
}

TEST_CASE("the order of strata is another for every axis, group and seed", "[sim]") {
    const auto order = [](const Design& design, int dimension) {
        std::vector<int> strata;
        for (const double value : draws(design, dimension))
            strata.push_back(static_cast<int>(value * design.n));
        return strata;
    };
    const Design first{Sampling::stratified, 40};
    CHECK(order(first, 0) == order(first, 0));
    CHECK(order(first, 0) != order(first, 1));
    CHECK(order(first, 0) != order({Sampling::stratified, 40, 1}, 0));
    CHECK(order(first, 0) != order({Sampling::stratified, 40, 0, 6}, 0));
    auto sorted = order(first, 0);
    CHECK_FALSE(std::is_sorted(sorted.begin(), sorted.end()));
}

TEST_CASE("any power of two of quasi-random items fills each part of every axis once", "[sim]") {
    for (int dimension = 0; dimension < SpreadAxis::most_dimensions; ++dimension) {
        const auto values = draws({Sampling::quasi, 256}, dimension);
        for (const std::size_t n : {2u, 16u, 256u})
            for (std::size_t first = 0; first + n <= values.size(); first += n) {
                const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
                INFO("dimension " << dimension << ", " << n << " from " << first);
                CHECK(filled_parts({begin, begin + static_cast<std::ptrdiff_t>(n)}) == n);
            }
    }
}

TEST_CASE("Sobol's first two axes fill every elementary rectangle once", "[sim]") {
    // The first two dimensions are a (0, 8, 2)-net in base 2, and a digital shift keeps that.
    const auto x = draws({Sampling::quasi, 256}, 0), y = draws({Sampling::quasi, 256}, 1);
    for (int x_bits = 0; x_bits <= 8; ++x_bits) {
        std::set<std::pair<int, int>> cells;
        for (std::size_t i = 0; i < x.size(); ++i)
            cells.insert({static_cast<int>(std::ldexp(x[i], x_bits)),
                          static_cast<int>(std::ldexp(y[i], 8 - x_bits))});
        CHECK(cells.size() == 256);
    }
}

TEST_CASE("without its shift the sequence is the one that is printed in books", "[sim]") {
    // Differences of digits cancel the shift: 0, 1/2, 3/4, 1/4 of the first axis become, in natural
    // order, 0, 1/2, 1/4, 3/4; of the third (Joe and Kuo's m = 1, 3) 0, 1/2, 3/4, 1/4.
    const auto digits = [](double u) { return static_cast<std::uint32_t>(u * 0x1p32 - 0.5); };
    const auto unshifted = [&](int dimension) {
        const auto values = draws({Sampling::quasi, 4}, dimension);
        std::vector<double> plain;
        for (const double value : values)
            plain.push_back((digits(value) ^ digits(values[0])) * 0x1p-32);
        return plain;
    };
    CHECK(unshifted(0) == std::vector<double>{0.0, 0.5, 0.25, 0.75});
    CHECK(unshifted(1) == std::vector<double>{0.0, 0.5, 0.75, 0.25});
    CHECK(unshifted(2) == std::vector<double>{0.0, 0.5, 0.75, 0.25});
}

TEST_CASE("quasi-random draws do not depend on how many follow, stratified ones do", "[sim]") {
    const auto few = draws({Sampling::quasi, 10}, 3), many = draws({Sampling::quasi, 100}, 3);
    CHECK(std::equal(few.begin(), few.end(), many.begin()));
    CHECK(draws({Sampling::stratified, 10}, 3)[0] != draws({Sampling::stratified, 100}, 3)[0]);
}

TEST_CASE("an integral over six axes converges faster over spread draws than over random ones",
          "[sim]") {
    // Sum of the axes' squares: 6/3. Mean of 20 groups' absolute errors, 256 items each.
    const auto error = [](Sampling sampling) {
        double sum = 0.0;
        for (std::uint32_t group = 0; group < 20; ++group) {
            double mean = 0.0;
            for (int dimension = 0; dimension < 6; ++dimension)
                for (const double u : draws({sampling, 256, group}, dimension))
                    mean += u * u / 256.0;
            sum += std::abs(mean - 2.0) / 20.0;
        }
        return sum;
    };
    const double random = error(Sampling::random);
    CHECK(random > 0.01);  // sd sqrt(6 * 4/45 / 256) = 0.046
    CHECK(error(Sampling::stratified) < random / 10.0);
    CHECK(error(Sampling::quasi) < random / 10.0);
}

}  // namespace
}  // namespace specula
