#include "sim/trace/target.hpp"

#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double same_direction = 1.0 - 1e-9;
constexpr double same_plane_m = 1e-7;

struct Plane {
    Vector3 point_m;
    Vector3 normal;
    bool holds(const Plane& other) const {
        return normal.dot(other.normal) > same_direction &&
               std::abs(normal.dot(other.point_m - point_m)) < same_plane_m;
    }
};

Plane plane_of(const TriangleSurface& t) {
    return {t.a_m, (t.b_m - t.a_m).cross(t.c_m - t.a_m).normalized()};
}

Mesh mesh_of(const std::vector<Surface>& surfaces) {
    Mesh mesh;
    for (const Surface& surface : surfaces) {
        const auto& triangle = std::get<TriangleSurface>(surface);
        const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
        mesh.vertices_m.insert(mesh.vertices_m.end(), {triangle.a_m, triangle.b_m, triangle.c_m});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// The flat parts of a body of triangles; nothing when there are too many.
std::vector<Face> flat_faces(const Body& body, int number) {
    std::vector<Face> faces;
    for (const Surface& surface : body.surfaces) {
        const auto* triangle = std::get_if<TriangleSurface>(&surface);
        if (!triangle) return {};
        const Plane plane = plane_of(*triangle);
        Face* home = nullptr;
        for (Face& face : faces)
            if (Plane{face.point_m, face.normal}.holds(plane)) home = &face;
        if (!home) {
            if (faces.size() == Target::most_flat_faces) return {};
            faces.push_back({.body = number,
                             .surfaces = {},
                             .flat = true,
                             .point_m = plane.point_m,
                             .normal = plane.normal});
            home = &faces.back();
        }
        home->surfaces.push_back(surface);
    }
    return faces;
}

/// One face of all surfaces; of a bowed plate, the plane is that of its centre.
Face whole_face(const Body& body, int number) {
    Face face{.body = number, .surfaces = body.surfaces};
    if (const auto* plate = std::get_if<PlateSurface>(&body.surfaces.front())) {
        face.flat = plate->plate.bow_m == 0.0;
        face.point_m = plate->placement.shift_m;
        face.normal = plate->placement.direction(Vector3::UnitZ());
    } else if (const auto* disc = std::get_if<DiscSurface>(&body.surfaces.front())) {
        face.flat = true;
        face.point_m = disc->placement.shift_m;
        face.normal = disc->placement.direction(Vector3::UnitZ());
    }
    return face;
}

Mesh mesh_of(const Face& face, const Body& body) {
    const Surface& first = face.surfaces.front();
    if (face.flat && std::holds_alternative<TriangleSurface>(first)) return mesh_of(face.surfaces);
    const auto* plate = std::get_if<PlateSurface>(&first);
    return plate && body.mesh.triangles.empty() ? triangulate(plate->plate, plate->placement)
                                                : body.mesh;
}

}  // namespace

Body plate_body(const Plate& plate, const Placement& placement, bool opaque, double thickness_m) {
    return {{PlateSurface{plate, placement}}, {}, opaque, thickness_m};
}

Body smooth_body(const Surface& surface) {
    constexpr std::uint32_t round = 256;  // chords of a 256th turn leave the circle by 1/13000
    const bool is_plate = std::holds_alternative<PlateSurface>(surface);
    return {{surface}, triangulate(surface, is_plate ? Cells{64, 64} : Cells{round, round})};
}

Body mesh_body(const Mesh& mesh, bool opaque, double thickness_m) {
    Body body{.surfaces = {}, .mesh = {}, .opaque = opaque, .thickness_m = thickness_m};
    for (const Vector3& vertex : mesh.vertices_m)
        if (!vertex.allFinite()) throw InputError("a mesh has a vertex that is not finite");
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle)
            if (index >= mesh.vertices_m.size())
                throw InputError(
                    format("a mesh of {} vertices names vertex {}", mesh.vertices_m.size(), index));
        const TriangleSurface surface{mesh.vertices_m[triangle[0]], mesh.vertices_m[triangle[1]],
                                      mesh.vertices_m[triangle[2]]};
        const double twice_area =
            (surface.b_m - surface.a_m).cross(surface.c_m - surface.a_m).norm();
        const double longest =
            std::max({(surface.b_m - surface.a_m).norm(), (surface.c_m - surface.b_m).norm(),
                      (surface.a_m - surface.c_m).norm()});
        if (!(twice_area > 1e-9 * longest * longest)) continue;
        body.surfaces.push_back(surface);
        body.mesh.triangles.push_back(triangle);
    }
    body.mesh.vertices_m = mesh.vertices_m;
    return body;
}

Target::Target(std::vector<Body> bodies) : bodies_(std::move(bodies)) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = bodies_[i];
        if (body.surfaces.empty()) continue;
        std::vector<Face> faces = flat_faces(body, static_cast<int>(i));
        if (faces.empty()) faces.push_back(whole_face(body, static_cast<int>(i)));
        faces_.insert(faces_.end(), faces.begin(), faces.end());
    }
    // A plate by itself may never be asked for; all else says at once what is wrong with it.
    if (!lone_plate()) geometry();
}

const Geometry& Target::geometry() const {
    std::call_once(rays_->once, [this] {
        std::vector<Mesh> meshes;
        for (const Face& face : faces_)
            meshes.push_back(mesh_of(face, bodies_[static_cast<std::size_t>(face.body)]));
        rays_->geometry = std::make_unique<Geometry>(meshes);
    });
    return *rays_->geometry;
}

const PlateSurface* Target::lone_plate() const {
    if (faces_.size() != 1 || faces_[0].surfaces.size() != 1) return nullptr;
    return std::get_if<PlateSurface>(&faces_[0].surfaces[0]);
}

}  // namespace specula
