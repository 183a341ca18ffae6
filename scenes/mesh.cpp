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

}  // namespace specula
