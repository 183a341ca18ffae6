#include "scenes/mesh.hpp"

namespace specula {

Mesh triangulate(const Plate& plate, const Placement& placement) {
    const std::uint32_t n = plate.bow_m == 0.0 ? 1 : 64;
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double x_m = plate.size_x_m * (static_cast<double>(i) / n - 0.5);
            const double y_m = plate.size_y_m * (static_cast<double>(j) / n - 0.5);
            mesh.vertices_m.push_back(placement.point({x_m, y_m, plate.height_m(x_m, y_m)}));
        }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

Mesh box_mesh(const Vector3& size_m) {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices_m.push_back({size_m.x() * ((corner & 1 ? 1.0 : 0.0) - 0.5),
                                   size_m.y() * ((corner & 2 ? 1.0 : 0.0) - 0.5),
                                   corner & 4 ? 0.0 : -size_m.z()});
    mesh.triangles = {{4, 5, 7}, {4, 7, 6}, {0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4},
                      {2, 7, 3}, {2, 6, 7}, {1, 3, 7}, {1, 7, 5}, {0, 6, 2}, {0, 4, 6}};
    return mesh;
}

Mesh placed(Mesh mesh, const Placement& placement) {
    for (Vector3& vertex : mesh.vertices_m) vertex = placement.point(vertex);
    return mesh;
}

}  // namespace specula
