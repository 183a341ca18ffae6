#pragma once

namespace specula {

/// The least experiment there can be: two classes, one world, a few frames; it runs in 0.3 s.
inline constexpr const char* small_study = R"(title = "Small"
question = "Does it run?"
seed = 1
worlds = 2
epochs = 2
radar = "iwrl6432boost"
nominal_height_mm = 450
merged_classes = ["wood", "iron"]
[sample]
size_mm = [100, 100]
[[class]]
name = "wood"
material = "wood"
thickness_mm = 10
[[class]]
name = "iron"
material = "iron"
thickness_mm = 3
[session]
[frame]
[training]
name = "training"
title = "Training"
validation_title = "Held back"
sessions = 1
frames = 3
[[condition]]
name = "higher"
title = "Higher"
height_mm = [550]
sessions = 1
frames = 2
[descriptor]
first_bin = 6
window = "blackman"
[classifier]
hidden = [4]
[quick]
worlds = 1
epochs = 1
)";

}  // namespace specula
