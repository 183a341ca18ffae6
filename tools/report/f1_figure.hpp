#pragma once

#include <optional>
#include <string>
#include <vector>

#include "classifier/report.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// One row of the figure.
struct F1Row {
    std::string name, title;
    Interval all, merged;                                 ///< in [0, 1]
    std::vector<double> all_per_world, merged_per_world;  ///< (world), in [0, 1]
    std::optional<double> paper;                          ///< in [0, 1]
};

struct F1Rows {
    std::vector<F1Row> rows;    ///< from top to bottom
    std::size_t n_classes = 0;  ///< chance is one in so many
    std::string all_label;      ///< e.g. "5 classes"
    std::string merged_label;   ///< e.g. "metals merged"
};

/// Macro-F1 per condition: dots with 95 % intervals over faint single worlds, for all classes and
/// for merged ones; stars are the paper's values, the dashed line is chance.
Figure f1_figure(const std::string& name, const F1Rows& content);

}  // namespace specula
