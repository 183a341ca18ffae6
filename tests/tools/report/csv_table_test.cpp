#include "tools/report/csv_table.hpp"

#include "sim/core/expect.hpp"
#include "tests/check.hpp"

using namespace specula;

TEST_CASE("cells with commas, quotes or line breaks are quoted", "[report]") {
    CsvTable table({"class", "share"});
    table.add({"plexiglass, 5 mm", "0.5"});
    table.add({"the \"new\" one\nhere", ""});
    CHECK(table.text() ==
          "class,share\n\"plexiglass, 5 mm\",0.5\n\"the \"\"new\"\" one\nhere\",\n");
}

TEST_CASE("a row of another length is a mistake of ours", "[report]") {
    CsvTable table({"a", "b"});
    CHECK_THROWS_AS(table.add({"1"}), BrokenPromise);
}
