#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/class_profile.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// One condition.
struct ProfilePanel {
    std::string name, title;
    std::vector<ClassProfile> classes;  ///< (class)
};

struct ProfilePanels {
    std::vector<ProfilePanel> panels;      ///< drawn row by row, three to a row, on equal axes
    std::vector<std::string> class_names;  ///< (class)
    int first_bin = 0;                     ///< range bin of the first feature
    std::string quantity;                  ///< vertical axis, e.g. "magnitude (ADC codes)"
    std::optional<double> marked_bin;      ///< vertical line, e.g. where the nominal height lies
};

/// Mean and +-1 sd band of the range-bin descriptor, per class: how the inputs drift.
Figure range_profile_figure(const std::string& name, const ProfilePanels& content);

}  // namespace specula
