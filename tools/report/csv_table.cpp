#include "tools/report/csv_table.hpp"

#include "sim/core/expect.hpp"

namespace specula {
namespace {

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

}  // namespace

void CsvTable::add(const std::vector<std::string>& row) {
    SPECULA_EXPECT(row.size() == n_columns_);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) text_ += ',';
        text_ += csv_cell(row[i]);
    }
    text_ += '\n';
}

}  // namespace specula
