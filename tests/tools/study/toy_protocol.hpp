#pragma once

#include "tests/made_up_folder.hpp"
#include "tests/tools/study/toy_experiment.hpp"

namespace specula {

/// The toy experiment with every part of a study's protocol, each as small as can be.
inline std::string toy_protocol() {
    std::string text = edited(toy_experiment, "epochs = 4\n", R"(epochs = 40
seeds = 2
check_worlds = 2
variant_worlds = 1
prior_draws = 1
severity_worlds = 1
ladder = true
variant_conditions = ["height"]
)");
    text = edited(text, "hidden = [6]\n", "hidden = [6]\nlearning_rate = 0.01\n");
    return edited(text, "[descriptor]\n", R"([calibration]
target_macro_f1 = 0.9
tolerance = 0.02
admissible_snr_db = [0, 6]
search_snr_db = [-12, 6]

[honesty]

[[training_set]]
name = "heights"
title = "Heights"
spread_height_mm = { uniform = [-110, 110] }
sessions = 2
frames = 6

[motion]
displacement_um = { normal = [0.0, 500.0] }

[[rung]]
name = "paper"
title = "As it is"

[[rung]]
name = "aligned"
title = "Aligned"
descriptor = "range_bins 6 12 blackman align 11.5 range 11.5 log 0.1 search 4 20"
training = "heights"

[[rung]]
name = "moving"
title = "Two looks in motion"
motion = true
descriptor = "range_bins 6 12 blackman looks 2 spread"

[[variant]]
name = "hann"
title = "Hann window"
window = "hann"

[severity]
height_offset_mm = [50]
tilt_deg = [5]
gain_db = [3]
frames = 2

[descriptor]
)");
}

}  // namespace specula
