#pragma once

#include <string>
#include <string_view>

#include "scenes/mesh.hpp"

namespace specula {

/// The three formats of mesh files. Each reader takes a file's whole content and its name for
/// messages, and returns the triangles in the file's unit. Counts in a file are checked against
/// what it holds before anything is made for them.
/// Each throws InputError `file:line: problem; remedy`, or `file: byte n: ...` where there are no
/// lines.

/// Wavefront OBJ: `v` and `f` (also a/b/c and negative indices); textures, normals, groups,
/// materials, lines and points are passed over; curved surfaces are refused.
Mesh read_obj(const std::string& file, std::string_view content);

/// STL, ascii or binary: binary when its length is that of its count.
Mesh read_stl(const std::string& file, std::string_view content);

/// PLY 1.0, ascii or binary of either byte order: `vertex` with x, y, z and `face` with
/// vertex_indices or vertex_index; everything else is passed over.
Mesh read_ply(const std::string& file, std::string_view content);

}  // namespace specula
