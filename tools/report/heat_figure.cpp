#include "tools/report/heat_figure.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/gnuplot.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/palette.hpp"

namespace specula {
namespace {

constexpr double heat_px = 912.0, heat_row_px = 24.0, panel_gap_px = 18.0, column_label_px = 10.0;
constexpr double title_line_px = 16.0;

struct HeatLayout {
    Canvas canvas;
    double left, top, panel_width_px;
    bool upright;  ///< columns too narrow for their names, which then stand on end

    PixelBox box(std::size_t panel, std::size_t n_rows) const {
        const double x = left + static_cast<double>(panel) * (panel_width_px + panel_gap_px);
        return {x, top, x + panel_width_px, top + heat_row_px * static_cast<double>(n_rows)};
    }
};

HeatLayout heat_layout(const HeatContent& content) {
    double label_px = 0.0;
    for (const std::string& row : content.rows)
        label_px = std::max(label_px, text_width_px(row, figure_font_px, true));
    const double left = std::min(label_px + 34.0, 0.5 * heat_px);
    const auto n_panels = static_cast<double>(content.panels.size());
    const double width = (heat_px - left - 10.0 - (n_panels - 1.0) * panel_gap_px) / n_panels;
    const double column_px = width / static_cast<double>(content.columns.size());
    std::size_t lines = 1, title_lines = 1;
    bool upright = false;
    double upright_px = 0.0;
    for (const std::string& column : content.columns) {
        const auto words = wrapped(column, column_px + 4.0);
        lines = std::max(lines, words.size());
        for (const std::string& word : words)
            upright = upright || text_width_px(word, column_label_px) > column_px;
        upright_px = std::max(upright_px, text_width_px(column, column_label_px) + 18.0);
    }
    for (const HeatPanel& panel : content.panels)
        title_lines = std::max(title_lines, wrapped(panel.title, width, true).size());
    const double top = 74.0 + title_line_px * static_cast<double>(title_lines - 1) +
                       (upright ? upright_px : 14.0 * static_cast<double>(lines));
    const double rows = static_cast<double>(content.rows.size());
    return {.canvas = {.width_px = heat_px, .height_px = top + heat_row_px * rows + 36.0},
            .left = left,
            .top = top,
            .panel_width_px = width,
            .upright = upright};
}

std::string heat_column_labels(const HeatContent& content, const HeatLayout& layout,
                               const PixelBox& box) {
    std::string text;
    const double column_px = layout.panel_width_px / static_cast<double>(content.columns.size());
    for (std::size_t i = 0; i < content.columns.size(); ++i) {
        if (layout.upright) {
            text += layout.canvas.label(
                {.text = content.columns[i],
                 .x_px = box.left + column_px * (static_cast<double>(i) + 0.5),
                 .y_px = layout.top - 8.0,
                 .size_px = column_label_px,
                 .upwards = true});
            continue;
        }
        const auto lines = wrapped(content.columns[i], column_px + 4.0);
        for (std::size_t line = 0; line < lines.size(); ++line)
            text += layout.canvas.label(
                {.text = lines[line],
                 .x_px = box.left + column_px * (static_cast<double>(i) + 0.5),
                 .y_px = layout.top - 10.0 - 14.0 * static_cast<double>(lines.size() - 1 - line),
                 .align = "center",
                 .size_px = column_label_px});
    }
    return text;
}

std::string heat_block(const HeatPanel& panel, std::size_t index) {
    std::string block = format("$h{} << END\n", index);
    for (std::size_t row = 0; row < panel.shares.size(); ++row)
        for (std::size_t column = 0; column < panel.shares[row].size(); ++column) {
            const auto& share = panel.shares[row][column];
            if (!share) continue;
            const Rgb ground = sequential_colour(*share);
            block += format("{} {} {} {} \"{}\"\n", column, row, ground.packed(),
                            text_colour_on(ground).packed(), fixed_text(100.0 * *share, 0));
        }
    return block + "END\n";
}

/// In as many lines as the panel's width asks for.
std::string heat_title(const HeatLayout& layout, const PixelBox& box, const std::string& title) {
    std::string text;
    double y_px = 56.0;
    for (const std::string& line : wrapped(title, layout.panel_width_px, true)) {
        text += layout.canvas.label({.text = line, .x_px = box.left, .y_px = y_px, .bold = true});
        y_px += title_line_px;
    }
    return text;
}

std::string heat_panel(const HeatContent& content, const HeatLayout& layout, std::size_t index) {
    const PixelBox box = layout.box(index, content.rows.size());
    std::string text =
        heat_block(content.panels[index], index) + layout.canvas.frame(box) +
        heat_column_labels(content, layout, box) +
        heat_title(layout, box, content.panels[index].title) +
        layout.canvas.label({.text = content.column_title,
                             .x_px = 0.5 * (box.left + box.right),
                             .y_px = box.bottom + 18.0,
                             .align = "center",
                             .colour = soft_ink});
    return text +
           format(
               "plot $h{0} using 1:2:($1-0.485):($1+0.485):($2-0.47):($2+0.47):3 with boxxyerror "
               "fillcolor rgb variable, '' using 1:2:5:4 with labels {1} textcolor rgb variable\n",
               index, font_clause(11));
}

std::string heat_script(const HeatContent& content) {
    const HeatLayout layout = heat_layout(content);
    std::string text =
        axes_style() +
        format(
            "unset grid\nset border 0\nunset xtics\nunset ytics\nset xrange [-0.5:{}]\n"
            "set yrange [{}:-0.5]\nset multiplot\n",
            static_cast<double>(content.columns.size()) - 0.5,
            static_cast<double>(content.rows.size()) - 0.5);
    const PixelBox heading{.left = 14.0, .top = 0.0, .right = 0.0, .bottom = 0.0};
    text += layout.canvas.heading(heading, content.title, content.second_line);
    for (std::size_t i = 0; i < content.rows.size(); ++i)
        text +=
            layout.canvas.label({.text = content.rows[i],
                                 .x_px = layout.left - 10.0,
                                 .y_px = layout.top + heat_row_px * (static_cast<double>(i) + 0.5),
                                 .align = "right",
                                 .bold = i < content.emphasised.size() && content.emphasised[i]});
    for (std::size_t panel = 0; panel < content.panels.size(); ++panel)
        text += (panel == 0 ? "" : "unset label\n") + heat_panel(content, layout, panel);
    return text + "unset multiplot\n";
}

std::string heat_csv(const HeatContent& content) {
    CsvTable table({"panel", "row", "column", "share"});
    for (const HeatPanel& panel : content.panels)
        for (std::size_t row = 0; row < content.rows.size(); ++row)
            for (std::size_t column = 0; column < content.columns.size(); ++column)
                if (const auto& share = panel.shares[row][column])
                    table.add({panel.title, content.rows[row], content.columns[column],
                               format("{:.6g}", *share)});
    return table.text();
}

}  // namespace

Figure heat_figure(const std::string& name, const HeatContent& content) {
    SPECULA_EXPECT(!content.rows.empty() && !content.columns.empty() && !content.panels.empty());
    for (const HeatPanel& panel : content.panels)
        SPECULA_EXPECT(panel.shares.size() == content.rows.size());
    const Canvas drawing = heat_layout(content).canvas;
    return {.name = name,
            .title = content.title,
            .description = format("{}: {} rows by {} columns, {}.", content.title,
                                  content.rows.size(), content.columns.size(), content.second_line),
            .script = heat_script(content),
            .csv = heat_csv(content),
            .width_in = drawing.width_in(),
            .height_in = drawing.height_in()};
}

}  // namespace specula
