#include "sim/trace/surface.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

SurfacePoint PlateSurface::at(double u, double v) const {
    const double half_x = 0.5 * plate.size_x_m, half_y = 0.5 * plate.size_y_m;
    const double x = half_x * u, y = half_y * v;
    const Vector3 normal = plate.area_normal(x, y);
    return {placement.point({x, y, plate.height_m(x, y)}),
            half_x * placement.direction({1.0, 0.0, -normal.x()}),
            half_y * placement.direction({0.0, 1.0, -normal.y()})};
}

SurfacePoint TriangleSurface::at(double u, double v) const {
    const double s = 0.5 * (1.0 + u), t = 0.5 * (1.0 + v);
    const Vector3 side = c_m - b_m, to_side = b_m - a_m + t * side;
    return {a_m + s * to_side, 0.5 * to_side, 0.5 * s * side};
}

SurfacePoint DiscSurface::at(double u, double v) const {
    const Vector3 outward(std::cos(pi * v), std::sin(pi * v), 0.0);
    const Vector3 around(-outward.y(), outward.x(), 0.0);
    const double r_m = 0.5 * (1.0 + u) * radius_m;
    return {placement.point(r_m * outward), placement.direction(0.5 * radius_m * outward),
            placement.direction(pi * r_m * around)};
}

SurfacePoint CylinderSurface::at(double u, double v) const {
    const Vector3 outward(std::cos(pi * u), std::sin(pi * u), 0.0);
    const Vector3 around(-outward.y(), outward.x(), 0.0);
    const Vector3 half_length(0.0, 0.0, 0.5 * length_m);
    return {placement.point(radius_m * outward + v * half_length),
            placement.direction(pi * radius_m * around), placement.direction(half_length)};
}

SurfacePoint SphereSurface::at(double u, double v) const {
    const double from_pole = 0.5 * pi * (1.0 + u);
    const Vector3 across(std::cos(pi * v), std::sin(pi * v), 0.0);
    const Vector3 around(-across.y(), across.x(), 0.0);
    const Vector3 outward = std::sin(from_pole) * across + std::cos(from_pole) * Vector3::UnitZ();
    const Vector3 away = std::cos(from_pole) * across - std::sin(from_pole) * Vector3::UnitZ();
    return {placement.point(radius_m * outward), placement.direction(0.5 * pi * radius_m * away),
            placement.direction(pi * radius_m * std::sin(from_pole) * around)};
}

SurfacePoint surface_point(const Surface& surface, double u, double v) {
    return std::visit([&](const auto& s) { return s.at(u, v); }, surface);
}

std::vector<Patch> patches_of(const Surface& surface) {
    const bool turns_along_u = std::holds_alternative<CylinderSurface>(surface);
    const bool is_sphere = std::holds_alternative<SphereSurface>(surface);
    const bool turns_along_v = is_sphere || std::holds_alternative<DiscSurface>(surface);
    const int n_u = turns_along_u ? 8 : is_sphere ? 4 : 1, n_v = turns_along_v ? 8 : 1;
    const auto edge = [](int i, int n) { return 2.0 * i / n - 1.0; };
    std::vector<Patch> patches;
    for (int i = 0; i < n_u; ++i)
        for (int j = 0; j < n_v; ++j)
            patches.push_back({{edge(i, n_u), edge(i + 1, n_u)}, {edge(j, n_v), edge(j + 1, n_v)}});
    return patches;
}

Mesh triangulate(const Surface& surface, const Cells& cells) {
    const auto& [n_u, n_v] = cells;
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n_v; ++j)
        for (std::uint32_t i = 0; i <= n_u; ++i)
            mesh.vertices_m.push_back(
                surface_point(surface, 2.0 * i / n_u - 1.0, 2.0 * j / n_v - 1.0).point_m);
    for (std::uint32_t j = 0; j < n_v; ++j) {
        for (std::uint32_t i = 0; i < n_u; ++i) {
            const std::uint32_t a = j * (n_u + 1) + i, b = a + 1, c = a + n_u + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

}  // namespace specula
