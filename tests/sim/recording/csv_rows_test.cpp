#include "sim/recording/csv_rows.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

using Cells = std::vector<std::string>;

std::string csv_refusal(const std::string& text) {
    return message_of([&] { return read_csv(bytes_in(text)).rows.size(); });
}

TEST_CASE("tables are read however other programs write them", "[recording]") {
    for (const std::string text :
         {"a,b\n1,2\n3,4\n", "a,b\r\n1,2\r\n3,4", "a;b\n1;2\n\n3;4\n\n", "a\tb\n1\t2\n3\t4\n",
          "\xef\xbb\xbf"
          "a,b\n1,2\n3,4\n"}) {
        const CsvRows table = read_csv(bytes_in(text));
        CHECK(table.columns == Cells{"a", "b"});
        REQUIRE(table.rows.size() == 2);
        CHECK(table.rows[1] == Cells{"3", "4"});
    }
    const std::string quoted = "name,x\n\"a, \"\"b\"\"\nc\",1\n";
    CHECK(read_csv(bytes_in(quoted)).rows[0] == Cells{"a, \"b\"\nc", "1"});
}

TEST_CASE("a cell comes back from its quotes", "[recording]") {
    for (const std::string cell : {"plain", "a,b", "say \"no\"", "two\nlines", ";", ""}) {
        const std::string text = "x,y\n1," + csv_cell(cell) + "\n";
        CHECK(read_csv(bytes_in(text)).rows.at(0) == Cells{"1", cell});
    }
}

TEST_CASE("tables with gaps are refused with the byte of the row", "[recording]") {
    CHECK(csv_refusal("") == "byte 0: the table is empty; write column names and rows");
    CHECK(csv_refusal("a,b\n") == "byte 4: no row follows the names; write rows");
    CHECK(csv_refusal("a,b\n1,2\n3\n") ==
          "byte 8: a row of 1 cells under 2 names; give each row one cell per column");
    CHECK(csv_refusal("a,b\n1,\"2\n") == "byte 6: a quote that does not end; close it");
    CHECK(csv_refusal("a,b\n1,\"2\"3\n") ==
          "byte 9: text behind a closed quote; double the quotes inside");
    CHECK(csv_refusal(std::string("a,b\n1,\0\n", 8)).rfind("byte 6: a zero byte", 0) == 0);
}

TEST_CASE("a number is a whole cell, finite, and no locale's", "[recording]") {
    CHECK(csv_number(" -1.5e-3 ", "x", 0) == -1.5e-3);
    for (const std::string cell : {"", " ", "1,5", "0x10", "nan", "inf", "1e999", "1 2", "a"})
        CHECK(message_of([&] {
                  return csv_number(cell, "x", 7);
              }).rfind("byte 7: x = \"" + cell + "\": is not a finite number", 0) == 0);
}

TEST_CASE("a table without names, or with a name twice, is refused", "[recording]") {
    CHECK(csv_refusal("1,2.5\n3,4\n").find("the first row holds numbers only") !=
          std::string::npos);
    CHECK(csv_refusal("a,b,a\n1,2,3\n").find("two columns are called \"a\"") != std::string::npos);
    CHECK(csv_refusal("a,2\n1,2\n").find("names") == std::string::npos);
}

}  // namespace
}  // namespace specula
