#pragma once

namespace specula {

/// An experiment of seconds: two worlds, two classes, small plates, two conditions.
inline constexpr const char* toy_experiment = R"(title = "Toy"
question = "Does it run?"
seed = 7
worlds = 2
epochs = 4
radar = "iwrl6432boost"
nominal_height_mm = 450
merged_classes = ["metal", "sheet"]

[sample]
size_mm = [60, 50]

[[class]]
name = "metal"
material = "iron"
thickness_mm = { factor = [3.0, 1.05] }
bow_mm = { uniform = [-0.2, 0.2] }

[[class]]
name = "sheet"
material = "plexiglass"
thickness_mm = { factor = [5.0, 1.04] }
permittivity_factor = { normal = [1.0, 0.01] }

[session]
height_mm = { normal = [0.0, 2.0] }
gain_db = { normal = [0.0, 0.3] }

[frame]
displacement_um = { normal = [0.0, 35.0] }

[world_clutter]
points = 2
level_db = -45
range_mm = { uniform = [250, 2000] }

[training]
name = "training"
title = "Training"
validation_title = "Held back"
sessions = 2
frames = 8
validation_share = 0.3

[[condition]]
name = "rerecorded"
title = "Recorded anew"
sessions = 1
frames = 3

[[condition]]
name = "height"
title = "Height"
height_mm = [350, 550]
sessions = 1
frames = 2

[descriptor]
first_bin = 6
n_bins = 12

[classifier]
hidden = [6]
batch_size = 16

[quick]
worlds = 1
epochs = 1

[paper]
reference = "Somebody, 2026"
macro_f1_nominal = 0.9
macro_f1_height = 0.5
)";

}  // namespace specula
