#pragma once

#include <string>
#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// A table of text: a line of column names, then lines of as many cells.
struct CsvRows {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< (row, column)
    std::vector<std::size_t> offset;             ///< (row), of its first byte
};

/// Cells are parted by commas, or by semicolons or tabs where the first line has more of them.
/// Quoted cells may hold any of that, and "" for a quote.
/// @eq  RFC 4180
/// Throws InputError with the byte of the row that has another number of cells, of a quote that
/// does not end, of a zero byte.
CsvRows read_csv(Bytes bytes);

/// A finite number and nothing else, whatever the locale; else InputError at `offset`.
double csv_number(const std::string& cell, const std::string& column, std::size_t offset);

/// A cell as it must stand in a file: quoted where it has to be.
std::string csv_cell(const std::string& text);

}  // namespace specula
