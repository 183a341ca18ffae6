#include "scenes/token_reader.hpp"

#include <charconv>
#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::string_view blank = " \t\r\v\f";
constexpr std::size_t longest_shown = 40;  // bytes of a wrong word

/// A word fit for a message: no control characters, no endless one.
std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, longest_shown)) text += c >= 0x20 && c < 0x7f ? c : '?';
    return word.size() > longest_shown ? text + "..." : text;
}

std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word.front() == '+' ? word.substr(1) : word;
}

}  // namespace

bool TokenReader::next_line() {
    if (next_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    rest_of_line_ = text_.substr(next_, end - next_);
    next_ = end + 1;
    ++line_;
    return true;
}

std::string_view TokenReader::word_in_line() {
    const std::size_t begin = rest_of_line_.find_first_not_of(blank);
    if (begin == std::string_view::npos) return rest_of_line_ = {};
    const std::size_t end =
        std::min(rest_of_line_.find_first_of(blank, begin), rest_of_line_.size());
    const std::string_view word = rest_of_line_.substr(begin, end - begin);
    rest_of_line_.remove_prefix(end);
    return word;
}

std::string_view TokenReader::word() {
    for (;;) {
        const std::string_view word = word_in_line();
        if (!word.empty() || !next_line()) return word;
    }
}

double TokenReader::number_from(std::string_view word, std::string_view what) const {
    if (word.empty()) fail(format("ends before {}", what), "is the file cut off? export it again");
    const std::string_view digits = without_plus(word);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
    if (error == std::errc::result_out_of_range)
        fail(format("{} = {}: is beyond what a number can hold", what, shown(word)),
             "correct it, or export the file again");
    if (error != std::errc() || end != digits.end())
        fail(format("{} = {}: is not a number", what, shown(word)),
             "correct it, or export the file again");
    if (!std::isfinite(value))
        fail(format("{} = {}: is not finite", what, shown(word)),
             "repair the mesh and export it again");
    return value;
}

std::int64_t TokenReader::whole_from(std::string_view word, std::string_view what) const {
    if (word.empty()) fail(format("ends before {}", what), "is the file cut off? export it again");
    const std::string_view digits = without_plus(word);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
    if (error != std::errc() || end != digits.end())
        fail(format("{} = {}: is not a whole number", what, shown(word)),
             "correct it, or export the file again");
    return value;
}

void TokenReader::fail(std::string_view problem, std::string_view remedy) const {
    throw InputError(
        format("{}:{}: {}; {}", file_, std::max<std::size_t>(line_, 1), problem, remedy));
}

}  // namespace specula
