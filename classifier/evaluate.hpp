#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "classifier/predict.hpp"
#include "classifier/report.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// One world in one condition: what the frames were, and what this world's own model made of them.
struct WorldOutcome {
    std::vector<std::uint8_t> truth;  ///< (example)
    Predictions predictions;          ///< (example)
};

/// How outcomes are scored; the same for all conditions of an experiment.
struct Scoring {
    std::vector<int> merged_class;  ///< (class) -> merged class, see merge_classes
    StreamKey bootstrap;            ///< one key for all, so that conditions share their resamples
};

/// The report of one condition over all worlds.
///
/// Counts are sums over worlds; every interval takes a world as one observation.
/// @in  worlds  at least one, each with at least one example, all of the same classes
ConditionReport evaluate(const std::string& name, const std::string& title,
                         std::span<const WorldOutcome> worlds, const Scoring& scoring);

}  // namespace specula
