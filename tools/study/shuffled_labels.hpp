#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// The classes of single frames dealt anew among the frames of one world.
FeatureTable with_shuffled_frames(const FeatureTable& rows, const StreamKey& key);

/// Macro-F1 of every world with its sessions kept together: each is judged by a model that saw none
/// of it, a quarter of the sessions at a time.
WorldScores leave_sessions_out(const WorldRows& rows, const StudyContext& context);

/// The classes of whole sessions dealt anew, in every world.
WorldRows with_shuffled_sessions(const WorldRows& rows, const StudyContext& context);

}  // namespace specula
