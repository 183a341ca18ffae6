#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace specula {

/// The words of a text file, with the line they stand on. Lines end with LF or CR LF; of a word
/// that is wrong, the messages say `file:line: problem; remedy`.
class TokenReader {
  public:
    /// @in  text  must outlive the reader
    TokenReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

    /// Goes to the next line; false where there is none. The first call reaches the first line.
    bool next_line();
    /// The next word of this line; empty at its end.
    std::string_view word_in_line();
    /// The next word on this or a later line; empty at the end of the file.
    std::string_view word();

    /// A finite number, or an InputError that says what it should have been.
    double number_from(std::string_view word, std::string_view what) const;
    std::int64_t whole_from(std::string_view word, std::string_view what) const;

    [[noreturn]] void fail(std::string_view problem, std::string_view remedy) const;
    std::size_t line() const { return line_; }
    /// Of the first byte that no line or word was taken from.
    std::size_t offset() const { return next_; }

  private:
    std::string file_;
    std::string_view text_;
    std::string_view rest_of_line_;
    std::size_t next_ = 0;
    std::size_t line_ = 0;
};

}  // namespace specula
