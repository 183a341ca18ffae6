#include "sim/core/document_seed.hpp"

#include <charconv>

namespace specula {

namespace {

/// The value as it stands in the file, without quotes; empty where it is no single value.
std::string seed_text(const Section& section) {
    const std::string key = "seed = ";
    for (const std::string& line : section.value_lines()) {
        if (line.rfind(key, 0) != 0) continue;
        const std::string value = line.substr(key.size());
        const bool is_quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"';
        return is_quoted ? value.substr(1, value.size() - 2) : value;
    }
    return "";
}

}  // namespace

std::uint64_t read_seed(Section& section) {
    if (!section.has("seed"))
        return static_cast<std::uint64_t>(section.count("seed", Range::any()));  // says so
    const std::string text = seed_text(section);
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size())
        section.fail("seed", "is not a whole number from 0 to 18446744073709551615",
                     "give one, in quotes where it is above 9223372036854775807");
    return seed;
}

}  // namespace specula
