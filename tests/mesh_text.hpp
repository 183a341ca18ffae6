#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <string>

namespace specula {

/// A number's bytes in an order.
template <typename Value>
std::string bytes_of(Value value, std::endian order) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return {bytes.begin(), bytes.end()};
}

/// A closed tetrahedron with legs of 10, 20 and 30 along the axes, as every kind of mesh file.
inline std::map<std::string, std::string> tetrahedron_files() {
    const float at[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {0, 0, 30}};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const auto words = [](const float(&v)[3]) {
        return std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]);
    };
    std::map<std::string, std::string> files;
    std::string obj = "# tetrahedron\n", ascii = "solid a b\n", binary(80, 'x'), table;
    binary += bytes_of(std::uint32_t{4}, std::endian::little);
    for (const auto& v : at) {
        obj += "v " + words(v) + "\n";
        table += words(v) + "\n";
    }
    for (const auto& face : faces) {
        obj += "f";
        ascii += "facet normal 0 0 0\n outer loop\n";
        binary += std::string(12, '\0');
        table += "3";
        for (const int corner : face) {
            obj += " " + std::to_string(corner + 1);
            table += " " + std::to_string(corner);
            ascii += "  vertex " + words(at[corner]) + "\n";
            for (const float coordinate : at[corner])
                binary += bytes_of(coordinate, std::endian::little);
        }
        obj += "\n";
        table += "\n";
        ascii += " endloop\nendfacet\n";
        binary += std::string(2, '\0');
    }
    files["text.obj"] = obj;
    files["text.stl"] = ascii + "endsolid a b\n";
    files["binary.stl"] = binary;
    const auto header = [](const std::string& format) {
        return "ply\nformat " + format +
               " 1.0\ncomment made up\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
               "end_header\n";
    };
    files["text.ply"] = header("ascii") + table;
    for (const auto order : {std::endian::little, std::endian::big}) {
        std::string body;
        for (const auto& v : at)
            for (const float coordinate : v) body += bytes_of(coordinate, order);
        for (const auto& face : faces) {
            body += '\3';
            for (const int corner : face) body += bytes_of(std::int32_t{corner}, order);
        }
        const bool little = order == std::endian::little;
        files[little ? "little.ply" : "big.ply"] =
            header(little ? "binary_little_endian" : "binary_big_endian") + body;
    }
    return files;
}

}  // namespace specula
