#pragma once

#include "tools/serve/lesson.hpp"
#include "tools/serve/rung_training.hpp"

namespace specula {

struct PageFacts {
    const Catalogue& catalogue;
    const KnownNames& known;
    const Experiment& experiment;
    const RungSet& models;
    const std::vector<Lesson>& lessons;
};

/// What the page needs to know once: its fields with ranges and units, materials, radars, the
/// models with the spread of what they learnt from and their scores, the lessons.
FloatJson page_description(const PageFacts& facts);

}  // namespace specula
