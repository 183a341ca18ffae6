#include "sim/recording/npy_header.hpp"

#include <charconv>
#include <set>

namespace specula {

namespace {

constexpr std::size_t most_axes = 32;  // as NumPy

/// Reads the little of Python that such headers are made of.
class Scanner {
  public:
    Scanner(const std::string& text, std::size_t offset) : text_(text), offset_(offset) {}

    [[noreturn]] void fail(const std::string& problem) const {
        fail_at(offset_ + at_, "in the header: " + problem, "save the array with numpy.save");
    }
    bool take(char wanted) {
        skip_space();
        if (at_ >= text_.size() || text_[at_] != wanted) return false;
        ++at_;
        return true;
    }
    void expect(char wanted) {
        if (!take(wanted)) fail(format("'{}' is missing", wanted));
    }
    std::string quoted() {
        skip_space();
        if (at_ < text_.size() && text_[at_] == '[')
            fail_at(offset_ + at_, "records of several fields",
                    "save each field as an array of its own");
        const char quote = at_ < text_.size() ? text_[at_] : ' ';
        if (quote != '\'' && quote != '"') fail("a text is missing");
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string::npos) fail("a text does not end");
        const std::string word = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return word;
    }
    bool boolean() {
        skip_space();
        for (const auto& [word, value] : {std::pair{"True", true}, std::pair{"False", false}})
            if (text_.compare(at_, std::char_traits<char>::length(word), word) == 0) {
                at_ += std::char_traits<char>::length(word);
                return value;
            }
        fail("True or False is missing");
    }
    std::size_t number() {
        skip_space();
        std::size_t value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc{}) fail("a length is missing or too large");
        at_ += static_cast<std::size_t>(end - begin);
        return value;
    }
    void finish() {
        skip_space();
        if (at_ != text_.size()) fail("something follows the dictionary");
    }

  private:
    void skip_space() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }
    const std::string& text_;
    std::size_t offset_;
    std::size_t at_ = 0;
};

std::vector<std::size_t> read_shape(Scanner& in) {
    std::vector<std::size_t> shape;
    in.expect('(');
    while (!in.take(')')) {
        if (shape.size() == most_axes) in.fail("there are too many axes");
        shape.push_back(in.number());
        if (in.take(',')) continue;
        in.expect(')');
        break;
    }
    return shape;
}

}  // namespace

NpyHeader parse_npy_header(const std::string& text, std::size_t offset) {
    Scanner in(text, offset);
    NpyHeader header;
    std::set<std::string> found;
    in.expect('{');
    while (!in.take('}')) {
        const std::string key = in.quoted();
        in.expect(':');
        if (key == "descr")
            header.descr = in.quoted();
        else if (key == "fortran_order")
            header.fortran_order = in.boolean();
        else if (key == "shape")
            header.shape = read_shape(in);
        else
            in.fail("an unknown key");
        if (!found.insert(key).second) in.fail("a key twice");
        if (in.take(',')) continue;
        in.expect('}');
        break;
    }
    in.finish();
    if (found.size() != 3) in.fail("descr, fortran_order or shape is missing");
    return header;
}

}  // namespace specula
