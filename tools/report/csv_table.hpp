#pragma once

#include <string>
#include <vector>

namespace specula {

/// Comma-separated text with one header line (RFC 4180, lines end in \n).
class CsvTable {
  public:
    explicit CsvTable(const std::vector<std::string>& header) : n_columns_(header.size()) {
        add(header);
    }

    /// `row` has as many cells as the header.
    void add(const std::vector<std::string>& row);
    const std::string& text() const { return text_; }

  private:
    std::size_t n_columns_;
    std::string text_;
};

}  // namespace specula
