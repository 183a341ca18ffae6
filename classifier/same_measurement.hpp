#pragma once

#include <optional>

#include "classifier/measurement.hpp"
#include "scenes/catalogue.hpp"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// The radar that frames name, where the catalogue has one of that name. A file's name says nothing
/// of what was in it.
std::optional<Radar> known_radar(const Dataset& frames, const Catalogue& catalogue);

/// Throws InputError `what = value: problem; remedy` unless these frames are such as a model was
/// trained on: of the same shape; and, where their radar is known, of the same chirp, number by
/// number as fw_model_accepts_chirp compares them.
void expect_same_measurement(const Measurement& trained, const Dataset& frames,
                             const std::optional<Radar>& radar);

}  // namespace specula
