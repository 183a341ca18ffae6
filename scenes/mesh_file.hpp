#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/mesh.hpp"

namespace specula {

/// A mesh as read, and what one should know of it.
struct MeshFile {
    Mesh mesh;
    bool is_watertight = false;
    std::vector<std::string> warnings;
};

/// Reads an OBJ, STL or PLY file, by the end of its name.
///
/// Triangles without area are left out and counted in a warning; seams that are open or shared by
/// more than two triangles make a warning too.
/// @in  unit_m  length of the file's unit, > 0
/// Throws InputError for a file that is no such mesh, holds coordinates that are not finite, is
/// larger than 512 MiB, has no triangle with area, or reaches farther than 100 m from its origin.
MeshFile read_mesh(const std::filesystem::path& file, double unit_m);

}  // namespace specula
