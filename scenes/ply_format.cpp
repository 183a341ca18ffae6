#include <optional>

#include "scenes/mesh_builder.hpp"
#include "scenes/mesh_formats.hpp"
#include "scenes/ply_header.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

using Type = ByteReader::Type;

constexpr double most_corners = 255.0;
constexpr double longest_list = 1e9;

/// The numbers behind the header, as text or as bytes.
class PlyBody {
  public:
    PlyBody(const TokenReader& text, std::optional<ByteReader> bytes)
        : text_(text), bytes_(std::move(bytes)) {}

    double finite_number(Type type, std::string_view what) {
        return bytes_ ? bytes_->finite_number(type) : text_.number_from(text_.word(), what);
    }
    void pass_over(Type type) {
        if (bytes_)
            bytes_->skip(ByteReader::size_of(type));
        else if (text_.word().empty())
            fail("the file ends here, within what it announced");
    }
    void pass_over(const PlyProperty& property) {
        if (!property.is_list) return pass_over(property.type);
        for (auto left = list_length(property, longest_list); left > 0; --left)
            pass_over(property.type);
    }
    std::uint64_t list_length(const PlyProperty& property, double most) {
        const double length = finite_number(property.count_type, "a list's length");
        if (!(length >= 0.0) || length > most || length != std::floor(length))
            fail(format("a list of {} numbers", length));
        return static_cast<std::uint64_t>(length);
    }
    [[noreturn]] void fail(std::string_view problem) const {
        constexpr std::string_view remedy = "correct it, or export the file again";
        if (bytes_) bytes_->fail(problem, remedy);
        text_.fail(problem, remedy);
    }

  private:
    TokenReader text_;
    std::optional<ByteReader> bytes_;
};

void read_vertex(PlyBody& body, const PlyElement& element, MeshBuilder& builder) {
    Vector3 vertex = Vector3::Zero();
    for (const PlyProperty& property : element.properties) {
        const auto axis = std::string_view("xyz").find(property.name);
        if (property.name.size() == 1 && axis != std::string_view::npos && !property.is_list)
            vertex[static_cast<int>(axis)] =
                body.finite_number(property.type, "a vertex's coordinate");
        else
            body.pass_over(property);
    }
    builder.add_vertex(vertex);
}

void read_face(PlyBody& body, const PlyElement& element, MeshBuilder& builder) {
    for (const PlyProperty& property : element.properties) {
        if (!property.is_list ||
            (property.name != "vertex_indices" && property.name != "vertex_index")) {
            body.pass_over(property);
            continue;
        }
        std::vector<std::uint32_t> corners;
        for (auto left = body.list_length(property, most_corners); left > 0; --left) {
            const double index = body.finite_number(property.type, "a face's vertex");
            if (!(index >= 0.0) || index >= static_cast<double>(builder.n_vertices()) ||
                index != std::floor(index))
                body.fail(format("a face names vertex {} of {}, counted from 0", index,
                                 builder.n_vertices()));
            corners.push_back(static_cast<std::uint32_t>(index));
        }
        const std::string problem = builder.add_polygon(corners);
        if (!problem.empty()) body.fail(problem);
    }
}

/// Do the vertices have x, y and z, and the faces a list of vertices?
void check_properties(const TokenReader& reader, const PlyHeader& header) {
    const auto has = [](const PlyElement& element, std::string_view name, bool as_list) {
        return std::any_of(
            element.properties.begin(), element.properties.end(),
            [&](const PlyProperty& p) { return p.name == name && p.is_list == as_list; });
    };
    bool has_vertices = false;
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex") {
            has_vertices = true;
            for (const char* axis : {"x", "y", "z"})
                if (!has(element, axis, false))
                    reader.fail(format("the vertices have no {}", axis), "export the file again");
        }
        if (element.name == "face" && !has_vertices)
            reader.fail("the faces stand before the vertices", "export the file again");
        if (element.name == "face" && !has(element, "vertex_indices", true) &&
            !has(element, "vertex_index", true))
            reader.fail("the faces have no vertex_indices", "export the file again");
    }
}

}  // namespace

Mesh read_ply(const std::string& file, std::string_view content) {
    TokenReader text(file, content);
    const PlyHeader header = read_ply_header(text);
    check_properties(text, header);
    std::optional<ByteReader> bytes;
    if (!header.is_ascii) {
        bytes.emplace(file, content, header.order);
        bytes->skip(std::min(text.offset(), content.size()));
    }
    PlyBody body(text, std::move(bytes));
    MeshBuilder builder;
    for (const PlyElement& element : header.elements) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (element.name == "vertex")
                read_vertex(body, element, builder);
            else if (element.name == "face")
                read_face(body, element, builder);
            else
                for (const PlyProperty& property : element.properties) body.pass_over(property);
        }
    }
    return builder.take();
}

}  // namespace specula
