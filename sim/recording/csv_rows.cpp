#include "sim/recording/csv_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace specula {

namespace {

char separator_of(const std::string& text) {
    const std::string first = text.substr(0, text.find('\n'));
    const auto occurs = [&first](char c) { return std::ranges::count(first, c); };
    if (occurs(';') > occurs(',') && occurs(';') >= occurs('\t')) return ';';
    return occurs('\t') > occurs(',') ? '\t' : ',';
}

/// Takes one line's cells after another's.
class Lines {
  public:
    explicit Lines(const std::string& text) : text_(text), separator_(separator_of(text)) {
        if (text_.compare(0, 3, "\xef\xbb\xbf") == 0) at_ = 3;  // byte order mark
    }

    std::size_t at() const { return at_; }
    /// Whether more than empty lines follow.
    bool more() {
        while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
        return at_ < text_.size();
    }
    std::vector<std::string> next() {
        std::vector<std::string> cells{cell()};
        while (at_ < text_.size() && text_[at_] == separator_) {
            ++at_;
            cells.push_back(cell());
        }
        return cells;
    }

  private:
    bool ends_cell() const {
        return at_ >= text_.size() || text_[at_] == separator_ || text_[at_] == '\n' ||
               text_[at_] == '\r';
    }
    std::string cell() {
        if (at_ < text_.size() && text_[at_] == '"') return quoted();
        const std::size_t begin = at_;
        while (!ends_cell()) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    std::string quoted() {
        const std::size_t begin = at_++;
        std::string cell;
        while (true) {
            const std::size_t quote = text_.find('"', at_);
            if (quote == std::string::npos) fail_at(begin, "a quote that does not end", "close it");
            cell += text_.substr(at_, quote - at_);
            at_ = quote + 1;
            if (at_ >= text_.size() || text_[at_] != '"') break;
            cell += text_[at_++];
        }
        if (!ends_cell()) fail_at(at_, "text behind a closed quote", "double the quotes inside");
        return cell;
    }

    const std::string& text_;
    char separator_;
    std::size_t at_ = 0;
};

bool is_number(const std::string& cell) {
    double ignored = 0.0;
    const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), ignored);
    return result.ec == std::errc{} && result.ptr == cell.data() + cell.size();
}

void check_names(std::vector<std::string> names) {
    if (std::ranges::all_of(names, is_number))
        fail_at(0, "the first row holds numbers only", "put a row of column names before it");
    std::ranges::sort(names);
    const auto twice = std::ranges::adjacent_find(names);
    if (twice != names.end())
        fail_at(0, format("two columns are called \"{}\"", *twice), "give each its own name");
}

}  // namespace

CsvRows read_csv(Bytes bytes) {
    const std::string text(bytes.begin(), bytes.end());
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos)
        fail_at(zero, "a zero byte", "name a text file of comma-separated values");
    CsvRows table;
    Lines lines(text);
    if (!lines.more()) fail_at(0, "the table is empty", "write column names and rows");
    table.columns = lines.next();
    check_names(table.columns);
    while (lines.more()) {
        table.offset.push_back(lines.at());
        table.rows.push_back(lines.next());
        if (table.rows.back().size() != table.columns.size())
            fail_at(table.offset.back(),
                    format("a row of {} cells under {} names", table.rows.back().size(),
                           table.columns.size()),
                    "give each row one cell per column");
    }
    if (table.rows.empty()) fail_at(bytes.size(), "no row follows the names", "write rows");
    return table;
}

double csv_number(const std::string& cell, const std::string& column, std::size_t offset) {
    const std::size_t first = std::min(cell.find_first_not_of(' '), cell.size());
    const std::size_t behind = cell.find_last_not_of(' ') + 1;  // 0 where there are only spaces
    double value = 0.0;
    const char* end = cell.data() + std::max(first, behind);
    const auto result = std::from_chars(cell.data() + first, end, value);
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value))
        fail_at(offset, format("{} = \"{}\": is not a finite number", column, cell.substr(0, 40)),
                "write it as 1.5e-3");
    return value;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",;\t\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace specula
