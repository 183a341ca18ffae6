#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// The study under every assumption of the experiment, one changed at a time; the file's own come
/// first. Judged on random frames of the training sessions and on the conditions that the
/// experiment names for it.
std::vector<SensitivityRow> sensitivity(const StudyContext& context);

/// Draws all assumptions at once, one world each, and keeps those whose nominal figure meets the
/// paper's: what the simulator predicts for the shifted conditions before they are looked at.
/// Laws: size 12 to 40 cm, ratio -30 to 0 dB, clutter -10 to 10 dB, session spreads times or
/// divided by up to 2, 4 to 16 sessions, window Hann or Blackman, each uniform in what it says.
PriorPrediction prior_prediction(const StudyContext& context, double paper_nominal);

}  // namespace specula
