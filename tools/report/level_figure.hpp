#pragma once

#include <string>
#include <vector>

#include "tools/report/figure.hpp"

namespace specula {

/// A level over tilt, height or frequency.
struct LevelCurve {
    std::string label;  ///< equal labels of different panels share colour and legend entry
    std::vector<double> x, level;
};

struct LevelPanel {
    std::string title;  ///< empty where there is one panel only
    std::vector<LevelCurve> curves;
    std::vector<LevelCurve> beside;  ///< drawn dashed and grey; `second_line` names them
};

struct LevelPanels {
    std::string title, second_line;
    std::string x_title, level_title;
    std::vector<LevelPanel> panels;  ///< on equal axes, three to a row
};

/// More curves than this cannot be told apart.
inline constexpr std::size_t most_level_curves = 7;
inline constexpr std::size_t most_level_panels = 12;

/// Small multiples of lines; at least one curve, at most `most_level_curves` labels.
Figure level_figure(const std::string& name, const LevelPanels& content);

}  // namespace specula
