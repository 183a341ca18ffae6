#include "scenes/ply_header.hpp"

#include <array>
#include <utility>

#include "sim/core/format.hpp"

namespace specula {

namespace {

using Type = ByteReader::Type;

constexpr std::array<std::pair<std::string_view, Type>, 16> type_names{{
    {"char", Type::int8},
    {"int8", Type::int8},
    {"uchar", Type::uint8},
    {"uint8", Type::uint8},
    {"short", Type::int16},
    {"int16", Type::int16},
    {"ushort", Type::uint16},
    {"uint16", Type::uint16},
    {"int", Type::int32},
    {"int32", Type::int32},
    {"uint", Type::uint32},
    {"uint32", Type::uint32},
    {"float", Type::float32},
    {"float32", Type::float32},
    {"double", Type::float64},
    {"float64", Type::float64},
}};

constexpr std::int64_t most_elements = 1'000'000'000;

Type type_of(const TokenReader& reader, std::string_view word) {
    for (const auto& [name, type] : type_names)
        if (name == word) return type;
    reader.fail("a property has no type of PLY", "use float, double, int, uchar and the like");
}

void read_format(TokenReader& reader, PlyHeader& header) {
    const std::string_view format_name = reader.word_in_line();
    header.is_ascii = format_name == "ascii";
    if (format_name == "binary_big_endian") header.order = std::endian::big;
    if (!header.is_ascii && format_name != "binary_little_endian" &&
        format_name != "binary_big_endian")
        reader.fail("the format is not known",
                    "use ascii, binary_little_endian or binary_big_endian");
    if (reader.word_in_line() != "1.0") reader.fail("is not PLY 1.0", "export it as PLY 1.0");
}

PlyElement read_element(TokenReader& reader) {
    PlyElement element;
    element.name = reader.word_in_line();
    const std::int64_t count = reader.whole_from(reader.word_in_line(), "an element's count");
    if (count < 0 || count > most_elements)
        reader.fail(format("an element's count = {}: is out of range", count),
                    format("give 0 to {}", most_elements));
    element.count = static_cast<std::uint64_t>(count);
    return element;
}

PlyProperty read_property(TokenReader& reader) {
    PlyProperty property;
    std::string_view word = reader.word_in_line();
    property.is_list = word == "list";
    if (property.is_list) {
        property.count_type = type_of(reader, reader.word_in_line());
        word = reader.word_in_line();
    }
    property.type = type_of(reader, word);
    property.name = reader.word_in_line();
    return property;
}

}  // namespace

PlyHeader read_ply_header(TokenReader& reader) {
    PlyHeader header;
    bool has_format = false;
    if (!reader.next_line() || reader.word_in_line() != "ply")
        reader.fail("\"ply\" should stand here", "is this a PLY file? export it again");
    while (reader.next_line()) {
        const std::string_view word = reader.word_in_line();
        if (word == "end_header") {
            if (!has_format) reader.fail("the header names no format", "export the file again");
            for (const PlyElement& element : header.elements)
                if (element.properties.empty() && element.count > 0)
                    reader.fail("an element has no property", "remove it, or export again");
            return header;
        }
        if (word.empty() || word == "comment" || word == "obj_info") continue;
        if (word == "format") {
            read_format(reader, header);
            has_format = true;
        } else if (word == "element") {
            header.elements.push_back(read_element(reader));
        } else if (word == "property") {
            if (header.elements.empty())
                reader.fail("a property stands before the first element", "export the file again");
            header.elements.back().properties.push_back(read_property(reader));
        } else {
            reader.fail("the header has a line that is not known",
                        "use format, comment, element, property and end_header");
        }
    }
    reader.fail("the file ends within its header", "is it cut off? export it again");
}

}  // namespace specula
