#include "sim/speckle_echo.hpp"

#include <algorithm>
#include <cmath>

#include "materials/diffuse.hpp"

namespace specula {

namespace {

/// Diffuse echoes below this share of the accuracy, in amplitude, are left out.
constexpr double share_of_accuracy = 0.3;

}  // namespace

std::vector<RoughLayer> rough_layers(const RoughBody& rough, const FrequencyComb& comb,
                                     double accuracy_db) {
    const double least = share_of_accuracy * (std::pow(10.0, accuracy_db / 20.0) - 1.0);
    std::vector<RoughLayer> layers;
    const Stack stacks[] = {rough.reflector(comb.first_hz), rough.reflector(comb.at(comb.n / 2)),
                            rough.reflector(comb.last_hz())};
    for (int number = 0; number < n_faces(stacks[0]); ++number) {
        double level = 0.0;
        for (const Stack& stack : stacks)
            level = std::max(level, diffuse_over_mirror(stack, face_of(stack, number)));
        if (level > least * least)
            layers.push_back({rough.body, number, face_of(stacks[0], number).correlation_m});
    }
    return layers;
}

void add_speckle(Scatter& scatter, const SpeckleScene& scene, const RoughBody& rough) {
    for (const RoughLayer& layer : rough_layers(rough, scene.comb, scene.accuracy_db)) {
        Stream piece({.seed = rough.piece,
                      .purpose = "speckle",
                      .world = 0,
                      .item = static_cast<std::uint32_t>(layer.body << 8 | layer.face)});
        std::optional<RouteScatter> cells;
        if (scene.plate) cells = drawn_thin_cells(*scene.plate, layer, piece);
        if (!cells) {
            cells = diffuse_cells(scene.target, scene.antennas, layer);
            draw_speckle(*cells, piece);
        }
        scatter.routes.push_back(std::move(*cells));
    }
}

}  // namespace specula
