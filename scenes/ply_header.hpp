#pragma once

#include <vector>

#include "scenes/byte_reader.hpp"
#include "scenes/token_reader.hpp"

namespace specula {

/// One number, or list of numbers, of a PLY element.
struct PlyProperty {
    std::string name;
    ByteReader::Type type{};
    bool is_list = false;
    ByteReader::Type count_type{};
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;  ///< at least one where count > 0
};

struct PlyHeader {
    bool is_ascii = true;
    std::endian order = std::endian::little;
    std::vector<PlyElement> elements;
};

/// Reads up to and with the line `end_header`.
PlyHeader read_ply_header(TokenReader& reader);

}  // namespace specula
