#pragma once

#include <optional>

#include "tools/study/ladder.hpp"

namespace specula {

/// The rung that is recommended, trained in every world as the ladder's first repeat was.
struct Remedy {
    const RungPlan* plan = nullptr;
    std::vector<Model> models;  ///< (world)
};

/// Nothing where the ladder recommends no rung.
std::optional<Remedy> train_remedy(const Ladder& ladder, const std::vector<RungPlan>& plans,
                                   const std::vector<LadderRung>& rungs);

/// models/remedy_world_000.json, ... below `folder`: with descriptor and chirp, so that `predict`
/// and, if the chip has code for the descriptor, `export model` and `verify-firmware` take them. Of
/// the first world's also the blob, where the chip can hold it.
DeviceFiles write_remedy(const Remedy& remedy, const Radar& radar,
                         const std::filesystem::path& folder);

}  // namespace specula
