#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/figure.hpp"

namespace specula {

struct HeatPanel {
    std::string title{};                                       ///< may be empty
    std::vector<std::vector<std::optional<double>>> shares{};  ///< (row, column), in [0, 1]
};

/// One or two matrices with the same rows and columns, beside each other.
struct HeatContent {
    std::string title{}, second_line{};
    std::string column_title{};
    std::vector<std::string> rows{}, columns{};
    std::vector<bool> emphasised{};  ///< (row); empty: none
    std::vector<HeatPanel> panels{};
};

/// Shares in percent, on a ground that darkens with the share.
Figure heat_figure(const std::string& name, const HeatContent& content);

}  // namespace specula
