#include <cstring>

#include "scenes/byte_reader.hpp"
#include "scenes/mesh_builder.hpp"
#include "scenes/mesh_formats.hpp"
#include "scenes/token_reader.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50;

Mesh read_binary(const std::string& file, std::string_view content, std::size_t n_triangles) {
    ByteReader reader(file, content, std::endian::little);
    reader.skip(header_bytes + 4);
    MeshBuilder builder;
    for (std::size_t i = 0; i < n_triangles; ++i) {
        reader.skip(12);  // the normal: the corners say it better
        for (int corner = 0; corner < 3; ++corner) {
            Vector3 vertex;
            for (double& coordinate : vertex)
                coordinate = reader.finite_number(ByteReader::Type::float32);
            builder.add_vertex(vertex);
        }
        reader.skip(2);
        const auto first = static_cast<std::uint32_t>(builder.n_vertices() - 3);
        const std::string problem = builder.add_polygon(std::array{first, first + 1, first + 2});
        if (!problem.empty()) reader.fail(problem, "give a coarser mesh");
    }
    return builder.take();
}

void expect_word(TokenReader& reader, std::string_view expected) {
    const std::string_view word = reader.word();
    if (word == expected) return;
    if (word.empty())
        reader.fail(format("the file ends where \"{}\" should stand", expected),
                    "is it cut off? export it again");
    reader.fail(format("\"{}\" should stand here", expected),
                "correct it, or export the file again");
}

void read_facet(TokenReader& reader, MeshBuilder& builder) {
    expect_word(reader, "normal");
    for (int axis = 0; axis < 3; ++axis) reader.word();  // the corners say it better
    expect_word(reader, "outer");
    expect_word(reader, "loop");
    for (int corner = 0; corner < 3; ++corner) {
        expect_word(reader, "vertex");
        Vector3 vertex;
        for (double& coordinate : vertex)
            coordinate = reader.number_from(reader.word(), "a vertex's coordinate");
        builder.add_vertex(vertex);
    }
    expect_word(reader, "endloop");
    expect_word(reader, "endfacet");
    const auto first = static_cast<std::uint32_t>(builder.n_vertices() - 3);
    const std::string problem = builder.add_polygon(std::array{first, first + 1, first + 2});
    if (!problem.empty()) reader.fail(problem, "give a coarser mesh");
}

/// One or more solids; each name is the rest of its line.
Mesh read_ascii(const std::string& file, std::string_view content) {
    TokenReader reader(file, content);
    MeshBuilder builder;
    while (reader.next_line()) {
        std::string_view word = reader.word_in_line();
        if (word.empty()) continue;
        if (word != "solid")
            reader.fail("\"solid\" should stand here", "is this an STL file? export it again");
        reader.next_line();
        for (word = reader.word(); word == "facet"; word = reader.word())
            read_facet(reader, builder);
        if (word.empty())
            reader.fail("the file ends where \"facet\" or \"endsolid\" should stand",
                        "is it cut off? export it again");
        if (word != "endsolid")
            reader.fail("\"facet\" or \"endsolid\" should stand here",
                        "correct it, or export the file again");
    }
    return builder.take();
}

}  // namespace

Mesh read_stl(const std::string& file, std::string_view content) {
    const bool says_solid = content.substr(0, 5) == "solid";
    if (content.size() >= header_bytes + 4) {
        ByteReader reader(file, content, std::endian::little);
        reader.skip(header_bytes);
        const auto n = static_cast<std::uint64_t>(reader.number(ByteReader::Type::uint32));
        const std::uint64_t expected = header_bytes + 4 + n * triangle_bytes;
        if (content.size() == expected) return read_binary(file, content, n);
        const bool has_zero = content.find('\0') != std::string_view::npos;
        if (!says_solid || has_zero)
            throw InputError(
                format("{}: byte {}: says {} triangles, which are {} bytes, and the "
                       "file has {}; is it cut off? export it again",
                       file, header_bytes, n, expected, content.size()));
    } else if (!says_solid) {
        throw InputError(
            format("{}: byte {}: the file ends within the header of a binary STL; "
                   "is it cut off? export it again",
                   file, content.size()));
    }
    return read_ascii(file, content);
}

}  // namespace specula
