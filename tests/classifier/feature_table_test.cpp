#include "classifier/feature_table.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"

namespace specula {
namespace {

TEST_CASE("selected rows keep their features, label, world and session", "[feature table]") {
    const FeatureTable table = draw({.n_rows = 20});
    const std::vector<std::size_t> indices{7, 0, 19, 7};
    const FeatureTable selected = select_rows(table, indices);
    REQUIRE(selected.size() == 4);
    CHECK(selected.class_names == table.class_names);
    CHECK(selected.extractor == "blobs");
    for (std::size_t i = 0; i < indices.size(); ++i) {
        CHECK(std::ranges::equal(selected.row(i), table.row(indices[i])));
        CHECK(selected.label[i] == table.label[indices[i]]);
        CHECK(selected.world[i] == table.world[indices[i]]);
        CHECK(selected.session[i] == table.session[indices[i]]);
    }
}

TEST_CASE("a condition and its opposite part a table", "[feature table]") {
    const FeatureTable table = draw({.n_rows = 20});
    const auto of_world_1 = [&](std::size_t i) { return table.world[i] == 1; };
    const FeatureTable inside = select_rows_where(table, of_world_1);
    const FeatureTable outside =
        select_rows_where(table, [&](std::size_t i) { return !of_world_1(i); });
    CHECK(inside.size() + outside.size() == table.size());
    CHECK(std::ranges::all_of(inside.world, [](int world) { return world == 1; }));
    CHECK(std::ranges::none_of(outside.world, [](int world) { return world == 1; }));
}

TEST_CASE("a row beyond the table is refused", "[feature table]") {
    const FeatureTable table = draw({.n_rows = 3});
    const std::vector<std::size_t> indices{3};
    CHECK_THROWS_AS(select_rows(table, indices), BrokenPromise);
}

}  // namespace
}  // namespace specula
