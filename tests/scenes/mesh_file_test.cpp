#include "scenes/mesh_file.hpp"

#include "scenes/mesh_checks.hpp"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/mesh_text.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

MeshFile mesh_in(const std::string& name, const std::string& content) {
    const MadeUpFolder folder;
    return read_mesh(folder.with(name, content), 1e-3);
}

/// What reading says, without the folder of the file.
std::string mesh_error(const std::string& name, const std::string& content) {
    const MadeUpFolder folder;
    const auto file = folder.with(name, content);
    const std::string message = message_of([&] { return read_mesh(file, 1e-3); });
    const auto at = message.find(name);
    return at == std::string::npos ? message : message.substr(at);
}

double area_m2(const Mesh& mesh) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * (mesh.vertices_m[b] - mesh.vertices_m[a])
                          .cross(mesh.vertices_m[c] - mesh.vertices_m[a])
                          .norm();
    return area;
}

TEST_CASE("a tetrahedron is the same from every format", "[mesh]") {
    for (const auto& [name, content] : tetrahedron_files()) {
        INFO(name);
        const MeshFile file = mesh_in(name, content);
        CHECK(file.mesh.vertices_m.size() == 4);
        CHECK(file.mesh.triangles.size() == 4);
        CHECK(file.is_watertight);
        CHECK(file.warnings.empty());
        // Three right angles of legs 10, 20, 30 mm, and the slope over them (de Gua's theorem).
        const double sides[] = {0.5 * 10 * 20, 0.5 * 10 * 30, 0.5 * 20 * 30};
        const double slope = std::hypot(sides[0], sides[1], sides[2]);
        CHECK(area_m2(file.mesh) ==
              Approx(1e-6 * (sides[0] + sides[1] + sides[2] + slope)).epsilon(1e-6));
    }
}

TEST_CASE("vertices of an OBJ may be counted back, carry textures, and end lines as on Windows",
          "[mesh]") {
    const MeshFile file =
        mesh_in("a.obj",
                "mtllib a.mtl\r\nv 0 0 0\r\nv 1 0 0 1.0\r\nvt 0 0\r\nv +0 1e0 0\r\n"
                "f -3/1 -2/1/1 -1//1\r\n");
    CHECK(file.mesh.triangles.size() == 1);
    CHECK(area_m2(file.mesh) == Approx(0.5e-6));
}

TEST_CASE("flat convex polygons become triangles of the same area, others are refused", "[mesh]") {
    const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 0.5 0\nv 2 2 1\n";
    CHECK(area_m2(mesh_in("a.obj", square + "f 1 2 3 4\n").mesh) == Approx(4e-6));
    for (const char* face : {"f 1 5 2 3", "f 1 2 6 4"})
        CHECK(mesh_error("a.obj", square + face) ==
              "a.obj:7: a face of 4 corners is not flat and convex; export the mesh as triangles");
}

TEST_CASE("what is wrong with a mesh is told with its place and a way out", "[mesh]") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    CHECK(mesh_error("a.obj", corners + "f 1 2 4\n") ==
          "a.obj:4: a face names vertex 4, and 3 vertices stand before it; vertices count from 1, "
          "or back from -1; correct the face");
    CHECK(mesh_error("a.obj", corners + "f 1 2 0\n").find("a.obj:4: a face names vertex 0") == 0);
    CHECK(mesh_error("a.obj", corners + "f 1 2\n").find("a.obj:4: a face of 2 corners") == 0);
    CHECK(mesh_error("a.obj", "v 0 nan 0\n") ==
          "a.obj:1: a vertex's coordinate = nan: is not finite; repair the mesh and export it "
          "again");
    CHECK(mesh_error("a.obj", "v 0 1e999 0\n").find("beyond what a number can hold") !=
          std::string::npos);
    CHECK(mesh_error("a.obj", "v 0 0\n").find("a.obj:1: ends before a vertex's coordinate") == 0);
    CHECK(mesh_error("a.obj", corners) == "a.obj: holds no triangle; is it the right file?");
    CHECK(mesh_error("a.obj", "v 0 0 0\nv 1e6 0 0\nv 0 1e6 0\nf 1 2 3\n") ==
          "a.obj: reaches 1e+03 m from its origin, and 100 m are the most; is the unit right?");
    CHECK(mesh_error("a.txt", corners) ==
          "a.txt: is no mesh by its name; give an .obj, .stl or .ply file");
    CHECK(mesh_error("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n") ==
          "a.stl:4: the file ends where \"vertex\" should stand; is it cut off? export it again");
    CHECK(mesh_error("a.stl", "hello") ==
          "a.stl: byte 5: the file ends within the header of a binary STL; is it cut off? export "
          "it again");
    CHECK(mesh_error("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                     "property float y\nend_header\n0 0\n") ==
          "a.ply:6: the vertices have no z; export the file again");
}

TEST_CASE("a file that says more than it holds is refused at the byte where it ends", "[mesh]") {
    auto files = tetrahedron_files();
    std::string stl = files.at("binary.stl");
    stl[80] = '\xff';
    stl[83] = '\x7f';
    CHECK(mesh_error("a.stl", stl)
              .find("a.stl: byte 80: says 2130706687 triangles, which are "
                    "106535334434 bytes, and the file has 284;") == 0);
    for (const char* name : {"little.ply", "big.ply"}) {
        const std::string ply = files.at(name);
        CHECK(mesh_error(name, ply.substr(0, ply.size() - 1)) ==
              std::string(name) + ": byte " + std::to_string(ply.size() - 1) +
                  ": the file ends here, within what it announced; is it cut off? export it again");
        const std::string more = edited(ply, "vertex 4", "vertex 999999999");
        CHECK(mesh_error(name, more).find("within what it announced") != std::string::npos);
    }
}

TEST_CASE("triangles without area are left out and counted, and none left is an error", "[mesh]") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\n";
    const MeshFile file = mesh_in("a.obj", corners + "f 1 2 3\nf 1 2 4\nf 1 1 3\n");
    CHECK(file.mesh.triangles.size() == 1);
    REQUIRE(file.warnings.size() == 2);
    CHECK(file.warnings[0].find("2 of 3 triangles have no area and are left out") !=
          std::string::npos);
    CHECK(mesh_error("a.obj", corners + "f 1 2 4\n") ==
          "a.obj: none of its 1 triangles has an area; export it again");
}

TEST_CASE("an open seam and one of three triangles are warned of", "[mesh]") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n";
    const MeshFile open = mesh_in("a.obj", corners + "f 1 2 3\n");
    CHECK_FALSE(open.is_watertight);
    CHECK(open.warnings.at(0).find("3 edges belong to one triangle only") != std::string::npos);
    const MeshFile fan = mesh_in("a.obj", corners + "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
    CHECK(fan.warnings.at(1).find("1 edges belong to more than two") != std::string::npos);
}

/// Bytes flipped, cut out, doubled: whatever comes, it is read or refused, and nothing not finite
/// gets through.
TEST_CASE("a damaged mesh is refused or read, but never believed blindly", "[mesh][fuzz]") {
    const MadeUpFolder folder;
    std::uint32_t state = 12345;
    const auto draw = [&state](std::size_t n) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::size_t>(state >> 8) % n;
    };
    int n_read = 0, n_refused = 0;
    for (const auto& [name, whole] : tetrahedron_files()) {
        for (int i = 0; i < 100; ++i) {
            std::string content = whole;
            for (std::size_t edits = 1 + draw(2); edits > 0 && !content.empty(); --edits) {
                const std::size_t at = draw(content.size());
                switch (draw(4)) {
                    case 0:
                        content[at] = static_cast<char>(draw(256));
                        break;
                    case 1:
                        content.erase(at, 1 + draw(20));
                        break;
                    case 2:
                        content.insert(at, content.substr(draw(content.size()), draw(40)));
                        break;
                    case 3:
                        content.resize(at);
                        break;
                }
            }
            const auto file = folder.with(name, content);
            try {
                const MeshFile read = read_mesh(file, 1e-3);
                for (const Vector3& vertex : read.mesh.vertices_m) REQUIRE(vertex.allFinite());
                for (const auto& triangle : read.mesh.triangles)
                    for (const auto corner : triangle)
                        REQUIRE(corner < read.mesh.vertices_m.size());
                ++n_read;
            } catch (const InputError& error) {
                REQUIRE(std::string(error.what()).find("; ") != std::string::npos);
                REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
                ++n_refused;
            }
        }
    }
    CHECK(n_read > 10);
    CHECK(n_refused > 200);
}

}  // namespace
}  // namespace specula
