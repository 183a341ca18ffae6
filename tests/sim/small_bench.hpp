#pragma once

#include "sim/generate.hpp"

namespace specula {

/// Five classes of small plates with laws for everything that varies: quick to simulate.
struct SmallBench {
    Radar radar;
    Population population;
    Library materials{SPECULA_SOURCE_DIR "/materials/library"};
    std::uint64_t seed = 7;

    SmallBench() {
        radar.name = "toy";
        radar.rx = {ReceiveChannel{.position_m = {0.004, 0.0, 0.0}},
                    ReceiveChannel{.position_m = {0.006, 0.002, 0.0}, .inverted = true}};
        radar.leakage = {Leakage{.range_m = 0.05, .level_dbm = -20.0}};
        for (const auto* name : {"iron", "aluminium", "plexiglass", "wood", "limestone"}) {
            SampleLaw law;
            law.name = law.nominal.material = name;
            law.nominal.face = {.size_x_m = 0.08, .size_y_m = 0.06};
            law.thickness_m = Distribution(Distribution::Factor{0.005, 1.1});
            law.bow_m = Distribution(Distribution::Uniform{-5e-4, 5e-4});
            law.roughness_m = Distribution(Distribution::Normal{0.0, 1e-5});
            law.permittivity_factor = Distribution(Distribution::Normal{1.0, 0.05});
            law.loss_factor = Distribution(Distribution::Factor{1.0, 1.3});
            population.classes.push_back(law);
        }
        population.session = {.height_m = Distribution(Distribution::Normal{0.0, 0.002}),
                              .tilt_rad = Distribution(Distribution::Normal{0.0, 0.01}),
                              .offset_m = Distribution(Distribution::Uniform{-0.005, 0.005}),
                              .yaw_rad = Distribution(Distribution::Normal{0.0, 0.03}),
                              .gain_db = Distribution(Distribution::Normal{0.0, 0.3}),
                              .leakage_db = Distribution(Distribution::Normal{0.0, 0.3}),
                              .leakage_rad = Distribution(Distribution::Normal{0.0, 0.1})};
        population.frame = {.displacement_m = Distribution(Distribution::Normal{0.0, 3.5e-5}),
                            .gain_db = Distribution(Distribution::Normal{0.0, 0.02})};
        population.world_clutter = {
            .points = 3, .range_m = Distribution(Distribution::Uniform{0.3, 1.5})};
        population.session_clutter = population.world_clutter;
    }

    Bench bench() const {
        return {.radar = radar,
                .population = population,
                .materials = materials,
                .nominal_height_m = 0.45,
                .seed = seed};
    }
};

/// Recordings at the nominal height, straight down.
inline Condition straight_down(int number) {
    Condition condition;
    condition.name = "condition_" + std::to_string(number);
    condition.number = number;
    condition.heights_m = {0.45};
    condition.sessions = 2;
    condition.frames = 3;
    return condition;
}

}  // namespace specula
