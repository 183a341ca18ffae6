#include <array>

#include "scenes/mesh_builder.hpp"
#include "scenes/mesh_formats.hpp"
#include "scenes/token_reader.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Statements of an OBJ file that say nothing about triangles.
constexpr std::array<std::string_view, 17> passed_over{
    "vt",     "vn",     "vp", "g", "o",   "s",     "mg",       "usemtl",  "mtllib",
    "usemap", "maplib", "l",  "p", "lod", "bevel", "c_interp", "d_interp"};

/// `7`, `7/1`, `7//3`, `-1/2/3`: the first number, counted from 0.
std::uint32_t corner_of(const TokenReader& reader, std::string_view word, std::size_t n_vertices) {
    const std::int64_t index = reader.whole_from(word.substr(0, word.find('/')), "a face's vertex");
    const auto n = static_cast<std::int64_t>(n_vertices);
    const std::int64_t from_zero = index < 0 ? n + index : index - 1;
    if (index == 0 || from_zero < 0 || from_zero >= n)
        reader.fail(format("a face names vertex {}, and {} vertices stand before it", index, n),
                    "vertices count from 1, or back from -1; correct the face");
    return static_cast<std::uint32_t>(from_zero);
}

}  // namespace

Mesh read_obj(const std::string& file, std::string_view content) {
    TokenReader reader(file, content);
    MeshBuilder builder;
    std::vector<std::uint32_t> corners;
    while (reader.next_line()) {
        const std::string_view statement = reader.word_in_line();
        if (statement.empty() || statement.front() == '#') continue;
        if (statement == "v") {
            Vector3 vertex;
            for (double& coordinate : vertex)
                coordinate = reader.number_from(reader.word_in_line(), "a vertex's coordinate");
            builder.add_vertex(vertex);
        } else if (statement == "f") {
            corners.clear();
            for (auto word = reader.word_in_line(); !word.empty(); word = reader.word_in_line())
                corners.push_back(corner_of(reader, word, builder.n_vertices()));
            const std::string problem = builder.add_polygon(corners);
            if (!problem.empty()) reader.fail(problem, "export the mesh as triangles");
        } else if (std::find(passed_over.begin(), passed_over.end(), statement) ==
                   passed_over.end()) {
            reader.fail(format("{} is no statement that is understood here",
                               statement.size() > 16 ? "this" : statement),
                        "export the mesh as triangles, with v and f lines");
        }
    }
    return builder.take();
}

}  // namespace specula
