#include "tools/specula/bin_choice.hpp"

#include <charconv>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::optional<BinChoice> parse_bin_choice(const std::string& text) {
    if (text.empty()) return std::nullopt;
    BinChoice choice;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, choice.first);
    if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ':') {
        const auto count = std::from_chars(first.ptr + 1, end, choice.count);
        if (count.ec == std::errc{} && count.ptr == end && choice.first >= 0 &&
            choice.first <= 65535 && choice.count >= 1 && choice.count <= 65535)
            return choice;
    }
    throw InputError(format("--bins = {}: is not FIRST:COUNT; 6:12 means bins 6 to 17", text));
}

}  // namespace specula
