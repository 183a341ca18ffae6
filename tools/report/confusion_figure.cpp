#include "tools/report/confusion_figure.hpp"

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/gnuplot.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/palette.hpp"

namespace specula {
namespace {

constexpr Canvas confusion_canvas{.width_px = 480, .height_px = 412};
constexpr PixelBox confusion_area{.left = 104, .top = 52, .right = 476, .bottom = 356};

struct Cell {
    std::size_t truth, predicted;
    std::int64_t n_frames;
    double share;  // of the frames of the true class; 0 if there are none
};

std::vector<Cell> cells_of(const Confusion& confusion) {
    std::vector<Cell> cells;
    for (std::size_t truth = 0; truth < confusion.n; ++truth) {
        std::int64_t n_row = 0;
        for (std::size_t j = 0; j < confusion.n; ++j) n_row += confusion.at(truth, j);
        for (std::size_t j = 0; j < confusion.n; ++j) {
            const auto n = confusion.at(truth, j);
            const double share =
                n_row > 0 ? static_cast<double>(n) / static_cast<double>(n_row) : 0;
            cells.push_back({truth, j, n, share});
        }
    }
    return cells;
}

/// (column, row, ground, ink, ink of the count, percentage, count); the first class is on top.
std::string data_block(const std::vector<Cell>& cells) {
    std::string block = "$cells << END\n";
    for (const Cell& cell : cells) {
        const Rgb ground = sequential_colour(cell.share);
        const Rgb text = cell.n_frames > 0 ? text_colour_on(ground) : Rgb{0x6a, 0x6e, 0x74};
        block += format("{} {} {} {} \"{}\" \"{}\"\n", cell.predicted, cell.truth, ground.packed(),
                        text.packed(), percent_text(cell.share), count_text(cell.n_frames));
    }
    return block + "END\n";
}

std::string class_ticks(const std::vector<std::string>& class_names) {
    std::string ticks;
    for (std::size_t i = 0; i < class_names.size(); ++i)
        ticks += format("{}{} {}", i > 0 ? ", " : "", gnuplot_quoted(class_names[i]), i);
    return "(" + ticks + ")";
}

std::string under_title(const ConditionReport& condition) {
    const std::size_t n_worlds = condition.macro_f1_per_world.size();
    return format("macro-F1 {}, 95\u00a0% interval {}, {} {}",
                  percent_text(condition.macro_f1.mean), range_text(condition.macro_f1), n_worlds,
                  n_worlds == 1 ? "world" : "worlds");
}

std::string script(const ConditionReport& condition, const std::vector<std::string>& class_names) {
    const std::string ticks = class_ticks(class_names);
    const double last = static_cast<double>(class_names.size()) - 0.5;
    return axes_style() + "unset grid\nset border 0\nset tics scale 0 textcolor rgb '#000000'\n" +
           confusion_canvas.frame(confusion_area) +
           confusion_canvas.heading(confusion_area, condition.title, under_title(condition)) +
           confusion_canvas.axis_titles(confusion_area, "predicted class", "true class") +
           data_block(cells_of(condition.confusion)) +
           format(
               "set xtics {0}\nset ytics {0}\nset xrange [-0.5:{1}]\nset yrange [{1}:-0.5]\n"
               "plot $cells using 1:2:($1-0.488):($1+0.488):($2-0.485):($2+0.485):3 "
               "with boxxyerror fillcolor rgb variable, "
               "'' using 1:($2-0.12):5:4 with labels {2} textcolor rgb variable, "
               "'' using 1:($2+0.19):6:4 with labels {3} textcolor rgb variable\n",
               ticks, last, font_clause(12.5), font_clause(10));
}

std::string csv(const ConditionReport& condition, const std::vector<std::string>& class_names) {
    CsvTable table(
        {"condition", "true_class", "predicted_class", "n_frames", "share_of_true_class"});
    for (const Cell& cell : cells_of(condition.confusion))
        table.add({condition.name, class_names[cell.truth], class_names[cell.predicted],
                   format("{}", cell.n_frames), format("{}", cell.share)});
    return table.text();
}

std::string description(const ConditionReport& condition,
                        const std::vector<std::string>& class_names) {
    std::string text = "Share of each true class that is recognised: ";
    for (const Cell& cell : cells_of(condition.confusion))
        if (cell.truth == cell.predicted)
            text += format("{}{} {}", cell.truth > 0 ? ", " : "", class_names[cell.truth],
                           percent_text(cell.share));
    return text + ".";
}

}  // namespace

Figure confusion_figure(const std::string& name, const ConditionReport& condition,
                        const std::vector<std::string>& class_names) {
    SPECULA_EXPECT(condition.confusion.n == class_names.size());
    return {.name = name,
            .title = "Confusion matrix: " + condition.title,
            .description = description(condition, class_names),
            .script = script(condition, class_names),
            .csv = csv(condition, class_names),
            .width_in = confusion_canvas.width_in(),
            .height_in = confusion_canvas.height_in()};
}

}  // namespace specula
