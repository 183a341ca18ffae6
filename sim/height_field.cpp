#include "sim/height_field.hpp"

#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double points_per_correlation = 5.0;
constexpr double most_triangles = 4e6;
constexpr double kernel_reach = 2.5;  ///< correlation lengths; beyond, the kernel is below 4e-6

/// Lattice points along one side of the plate, and the kernel along it, of unit energy.
struct Side {
    std::size_t n = 0;
    double pitch_m = 0.0;
    std::vector<double> kernel;

    Side(double size_m, double correlation_m) {
        const double n_steps = std::ceil(size_m / correlation_m * points_per_correlation);
        n = static_cast<std::size_t>(n_steps) + 1;
        pitch_m = size_m / n_steps;
        const int reach = static_cast<int>(std::ceil(kernel_reach * correlation_m / pitch_m));
        double energy = 0.0;
        for (int i = -reach; i <= reach; ++i) {
            kernel.push_back(std::exp(-2.0 * std::pow(i * pitch_m / correlation_m, 2)));
            energy += kernel.back() * kernel.back();
        }
        for (double& value : kernel) value /= std::sqrt(energy);
    }
    std::size_t n_noise() const { return n + kernel.size() - 1; }
};

/// (y, x) heights of unit variance: noise smoothed along x, then along y.
std::vector<double> unit_heights(const Side& x, const Side& y, Stream& piece) {
    std::vector<double> along_x(y.n_noise() * x.n, 0.0), noise(x.n_noise());
    for (std::size_t row = 0; row < y.n_noise(); ++row) {
        piece.fill_normal(noise);
        for (std::size_t i = 0; i < x.n; ++i)
            for (std::size_t t = 0; t < x.kernel.size(); ++t)
                along_x[row * x.n + i] += x.kernel[t] * noise[i + t];
    }
    std::vector<double> heights(y.n * x.n, 0.0);
    for (std::size_t j = 0; j < y.n; ++j)
        for (std::size_t t = 0; t < y.kernel.size(); ++t)
            for (std::size_t i = 0; i < x.n; ++i)
                heights[j * x.n + i] += y.kernel[t] * along_x[(j + t) * x.n + i];
    return heights;
}

}  // namespace

Mesh height_field(const Plate& plate, const Heights& heights, Stream& piece) {
    const double per_m = points_per_correlation / heights.correlation_m;
    const double n_triangles = 2.0 * plate.size_x_m * plate.size_y_m * per_m * per_m;
    if (n_triangles > most_triangles)
        throw InputError(
            format("solver.roughness = height_field: {:.3g} triangles of a fifth of "
                   "the correlation length; use statistical, or a smaller sample",
                   n_triangles));
    const Side x(plate.size_x_m, heights.correlation_m), y(plate.size_y_m, heights.correlation_m);
    const std::vector<double> unit = unit_heights(x, y, piece);
    Mesh mesh;
    for (std::size_t j = 0; j < y.n; ++j) {
        for (std::size_t i = 0; i < x.n; ++i) {
            const double at_x = static_cast<double>(i) * x.pitch_m - 0.5 * plate.size_x_m;
            const double at_y = static_cast<double>(j) * y.pitch_m - 0.5 * plate.size_y_m;
            mesh.vertices_m.emplace_back(
                at_x, at_y, plate.height_m(at_x, at_y) + heights.rms_m * unit[j * x.n + i]);
        }
    }
    const auto index = [&](std::size_t i, std::size_t j) {
        return static_cast<std::uint32_t>(j * x.n + i);
    };
    for (std::size_t j = 0; j + 1 < y.n; ++j) {
        for (std::size_t i = 0; i + 1 < x.n; ++i) {
            mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
            mesh.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return mesh;
}

Scene with_height_field(const Scene& scene) {
    if (scene.sample.mesh || scene.sample.roughness_m == 0.0) return scene;
    Scene rough = scene;
    Sample& sample = rough.sample;
    Stream piece({.seed = sample.piece, .purpose = "heights"});
    sample.mesh = std::make_shared<const Mesh>(
        height_field(sample.face, {sample.roughness_m, sample.correlation_m}, piece));
    sample.roughness_m = 0.0;
    if (!sample.layers.empty()) sample.layers.front().roughness_m = 0.0;
    return rough;
}

}  // namespace specula
