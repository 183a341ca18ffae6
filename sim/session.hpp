#pragma once

#include "scenes/solver.hpp"
#include "sim/adc/receiver_chain.hpp"
#include "sim/condition.hpp"
#include "sim/dataset/truth.hpp"
#include "sim/population.hpp"

namespace specula {

/// Everything that a session is simulated from.
struct Bench {
    const Radar& radar;
    const Population& population;
    const Library& materials;
    double nominal_height_m;
    std::uint64_t seed;
    Solver solver{};
};

/// Which session of which condition.
struct SessionId {
    int world = 0;
    int label = 0;  ///< class
    int session = 0;

    static constexpr int most_worlds = 1024;
};

struct SessionFrames {
    std::vector<std::int16_t> adc;             ///< (frame, chirp, rx, sample)
    std::vector<std::int16_t> adc_quadrature;  ///< likewise, of a complex receiver; else empty
    std::vector<Truth> truth;                  ///< (frame)
    bool is_weak = false;                      ///< echo_limits has something to say
};

/// Draws the sample, its placement and the state of the board, traces the scene once, and records
/// the session's frames. Depends on nothing but its arguments.
SessionFrames simulate_session(const Bench& bench, const Condition& condition, const SessionId& id);

}  // namespace specula
