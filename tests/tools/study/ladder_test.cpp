#include "tools/study/ladder.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

/// A rung of one condition, merged macro-F1 world by world.
LadderRung rung_of(const std::vector<double>& merged, std::size_t multiplications = 1000) {
    LadderRung rung;
    rung.cost.multiplications = multiplications;
    rung.domains = {{.domain = "height", .per_world = {.all = merged, .merged = merged}}};
    return rung;
}

std::size_t recommended_of(std::vector<LadderRung> rungs) {
    recommend(rungs, choosing_worlds(4));
    for (std::size_t i = 0; i < rungs.size(); ++i)
        if (rungs[i].recommended) return i;
    return rungs.size();
}

TEST_CASE("every other world decides, and the rest have no say", "[study]") {
    CHECK(choosing_worlds(5) == std::vector<std::size_t>{0, 2, 4});
    CHECK(choosing_worlds(1) == std::vector<std::size_t>{0});
    // Better on the mean of all four worlds, worse on the two that decide.
    CHECK(recommended_of({rung_of({0.8, 0.5, 0.8, 0.5}), rung_of({0.7, 1.0, 0.7, 1.0})}) == 0);
    CHECK(recommended_of({rung_of({0.7, 1.0, 0.7, 1.0}), rung_of({0.8, 0.5, 0.8, 0.5})}) == 1);
}

TEST_CASE("of rungs within half a point the cheapest is recommended", "[study]") {
    CHECK(recommended_of({rung_of({0.900, 0, 0.900, 0}, 900), rung_of({0.903, 0, 0.903, 0}, 500),
                          rung_of({0.906, 0, 0.906, 0}, 800)}) == 1);
}

TEST_CASE("what needs the true gain is never recommended", "[study]") {
    LadderRung ideal = rung_of({1, 1, 1, 1});
    ideal.descriptor = "range_bins 6 12 blackman over the true gain";
    CHECK(recommended_of({rung_of({0.5, 0.5, 0.5, 0.5}), ideal}) == 0);
}

}  // namespace
}  // namespace specula
