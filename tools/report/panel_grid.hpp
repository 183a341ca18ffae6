#pragma once

#include <algorithm>

#include "tools/report/canvas.hpp"

namespace specula {

/// Where small multiples stand on a figure: three to a row, a legend above all, a title above each.
struct PanelGrid {
    static constexpr double width_px = 912.0, panel_px = 190.0, legend_px = 36.0, bottom_px = 54.0;
    static constexpr double left_px = 68.0, right_px = 8.0, gap_x_px = 22.0, below_panel_px = 40.0;
    static constexpr double line_px = 16.0, title_gap_px = 10.0;

    std::size_t n_panels;
    double title_px = 0.0;  ///< height of the highest title of a panel

    std::size_t n_columns() const { return std::min<std::size_t>(3, n_panels); }
    std::size_t n_rows() const { return (n_panels + n_columns() - 1) / n_columns(); }
    double row_px() const { return title_px + title_gap_px + panel_px; }
    double panel_width_px() const {
        const auto columns = static_cast<double>(n_columns());
        return (width_px - left_px - right_px - (columns - 1.0) * gap_x_px) / columns;
    }
    Canvas canvas() const {
        const auto rows = static_cast<double>(n_rows());
        return {
            .width_px = width_px,
            .height_px = legend_px + rows * row_px() + (rows - 1.0) * below_panel_px + bottom_px};
    }
    PixelBox panel(std::size_t index) const {
        const auto column = static_cast<double>(index % n_columns());
        const auto row = static_cast<double>(index / n_columns());
        const double left = left_px + column * (panel_width_px() + gap_x_px);
        const double bottom = legend_px + (row + 1.0) * row_px() + row * below_panel_px;
        return {.left = left,
                .top = bottom - panel_px,
                .right = left + panel_width_px(),
                .bottom = bottom};
    }
    bool is_lowest(std::size_t index) const { return index + n_columns() >= n_panels; }
};

}  // namespace specula
