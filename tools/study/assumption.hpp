#pragma once

#include <array>
#include <optional>
#include <string>

#include "scenes/pose.hpp"
#include "sim/core/document.hpp"

namespace specula {

struct Experiment;

/// One way in which things could be otherwise than the experiment's file says: what the paper
/// leaves open, or what a severity of the grid is. Nothing set: as the file says.
struct Assumption {
    std::string name = "reference";
    std::string title = "As assumed";
    double snr_db = 0.0;                          ///< more signal to noise, by less noise
    double gain_db = 0.0;                         ///< of all sessions
    double clutter_db = 0.0;                      ///< both the world's and the sessions'
    double spread_factor = 1.0;                   ///< on the spreads of the sessions' laws
    double slope_factor = 1.0;                    ///< on the chirp's slope, so on its bandwidth
    std::optional<std::array<double, 2>> size_m;  ///< of all samples
    std::optional<Vector3> pivot_m;               ///< where tilted samples turn about
    std::optional<int> sessions;                  ///< of training, at the same number of frames
    std::optional<int> first_bin;                 ///< of the descriptor
    std::optional<std::string> window;            ///< of the descriptor
};

/// Reads one [[variant]]. Throws InputError for values out of range.
Assumption read_assumption(Section section);

/// The experiment under another assumption: radar, population, training, conditions, descriptor.
/// Conditions keep their numbers, so that what an assumption does not concern is drawn the same.
Experiment under(const Assumption& assumption, const Experiment& experiment);

}  // namespace specula
