#include "scenes/mesh_file.hpp"

#include <fstream>
#include <sstream>

#include "scenes/mesh_checks.hpp"
#include "scenes/mesh_formats.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = 512u << 20;
constexpr double farthest_m = 100.0;

std::string content_of_mesh(const fs::path& file) {
    std::error_code ignored;
    const std::string name = file.string();
    if (!fs::exists(file, ignored)) throw InputError(name + ": no such file; check the path");
    if (!fs::is_regular_file(file, ignored))
        throw InputError(name + ": is not a regular file; name an OBJ, STL or PLY file");
    if (fs::file_size(file, ignored) > most_bytes)
        throw InputError(name + ": is larger than 512 MiB; give a coarser mesh");
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in.is_open() || in.bad())
        throw InputError(name + ": cannot be read; check its permissions");
    return text.str();
}

Mesh read_by_name(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const std::string name = file.string();
    if (ending != ".obj" && ending != ".stl" && ending != ".ply")
        throw InputError(name + ": is no mesh by its name; give an .obj, .stl or .ply file");
    const std::string content = content_of_mesh(file);
    if (ending == ".obj") return read_obj(name, content);
    if (ending == ".stl") return read_stl(name, content);
    return read_ply(name, content);
}

void warn_of_seams(MeshFile& read, const std::string& name) {
    const Seams seams = seams_of(read.mesh);
    read.is_watertight = seams.is_watertight();
    if (seams.n_open > 0)
        read.warnings.push_back(
            format("{}: is not watertight: {} edges belong to one triangle "
                   "only; both of its sides reflect",
                   name, seams.n_open));
    if (seams.n_shared > 0)
        read.warnings.push_back(
            format("{}: {} edges belong to more than two triangles; inside and outside are not "
                   "told apart",
                   name, seams.n_shared));
}

}  // namespace

MeshFile read_mesh(const fs::path& file, double unit_m) {
    const std::string name = file.string();
    MeshFile read;
    read.mesh = read_by_name(file);
    for (Vector3& vertex : read.mesh.vertices_m) vertex *= unit_m;
    const std::size_t n_all = read.mesh.triangles.size();
    if (n_all == 0) throw InputError(name + ": holds no triangle; is it the right file?");
    for (const auto& triangle : read.mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (!(read.mesh.vertices_m[corner].norm() <= farthest_m))
                throw InputError(
                    format("{}: reaches {:.3g} m from its origin, and {:.3g} m are the "
                           "most; is the unit right?",
                           name, read.mesh.vertices_m[corner].norm(), farthest_m));
    const std::size_t n_degenerate = drop_degenerate(read.mesh);
    if (n_degenerate == n_all)
        throw InputError(
            format("{}: none of its {} triangles has an area; export it again", name, n_all));
    if (n_degenerate > 0)
        read.warnings.push_back(format("{}: {} of {} triangles have no area and are left out", name,
                                       n_degenerate, n_all));
    warn_of_seams(read, name);
    return read;
}

}  // namespace specula
