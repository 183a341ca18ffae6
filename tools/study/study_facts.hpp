#pragma once

#include "scenes/catalogue.hpp"
#include "tools/report/study_summary.hpp"
#include "tools/study/recordings.hpp"

namespace specula {

/// What a summary says of an experiment and its recordings before anything is judged.

/// Mean and standard deviation of every feature, class by class.
std::vector<ClassProfile> profiles_of(const FeatureTable& rows);

/// Class -> merged class: the named ones together, the others each alone.
std::vector<int> merged_map(const Experiment& experiment);

std::string merged_label(const Experiment& experiment);

RadarFacts facts_of(const Experiment& experiment);

/// Of all classes, each once: materials outside their band, and where optics is known to fail.
std::vector<std::string> warnings_of(const Experiment& experiment, const Library& materials);

void warn_of_weak_echoes(const std::vector<Recording>& recordings, const Experiment& experiment,
                         const RunSettings& run, std::vector<std::string>& warnings);

}  // namespace specula
