#include "tools/sweep/sweep_figures.hpp"

#include <algorithm>
#include <cmath>

#include "sim/clutter.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/report/level_figure.hpp"

namespace specula {

namespace {

/// One axis of the grid, as figures use it.
struct GridAxis {
    const char* name;  ///< "tilt"
    std::string title;
    std::size_t SweepIndex::*index;
    std::vector<double> x;           ///< (value); empty where nothing is drawn over it
    std::vector<std::string> label;  ///< (value)
};

std::string size_label(const std::array<double, 2>& size_m) {
    return size_m[0] == size_m[1] ? format("{:g} cm", size_m[0] * 100.0)
                                  : format("{:g} x {:g} cm", size_m[0] * 100.0, size_m[1] * 100.0);
}

/// In the order specimen, size, tilting, height, tilt, frequency.
std::vector<GridAxis> axes_of(const SweepPlan& plan) {
    GridAxis specimen{"specimen", "", &SweepIndex::specimen, {}, {}};
    for (const Specimen& each : plan.specimens) specimen.label.push_back(each.label);
    GridAxis size{"size", "edge of the sample (mm)", &SweepIndex::size, {}, {}};
    for (const auto& size_m : plan.sizes_m) size.label.push_back(size_label(size_m));
    GridAxis tilting{"tilting", "", &SweepIndex::tilting, {}, {}};
    for (const Tilting& each : plan.tiltings) tilting.label.push_back(each.title());
    GridAxis height{"height", "height (mm)", &SweepIndex::height, {}, {}};
    for (const double height_m : plan.heights_m) {
        height.x.push_back(height_m * 1e3);
        height.label.push_back(format("height {:g} mm", height_m * 1e3));
    }
    GridAxis tilt{"tilt", "tilt (degrees)", &SweepIndex::tilt, {}, {}};
    for (const double tilt_rad : plan.tilts_rad) {
        tilt.x.push_back(tilt_rad * 180.0 / pi);
        tilt.label.push_back(format("tilt {:g}\u00b0", tilt.x.back()));
    }
    GridAxis frequency{"frequency", "frequency (GHz)", &SweepIndex::frequency, {}, {""}};
    if (!plan.frequencies_hz.empty()) frequency.label.clear();
    for (const double f_hz : plan.frequencies_hz) {
        frequency.x.push_back(f_hz * 1e-9);
        frequency.label.push_back(format("{:g} GHz", f_hz * 1e-9));
    }
    if (plan.heights_m.size() == 1 && plan.tilts_rad.size() == 1 && plan.n_frequencies() == 1)
        for (const auto& size_m : plan.sizes_m) size.x.push_back(size_m[0] * 1e3);
    return {specimen, size, tilting, height, tilt, frequency};
}

/// Every combination of the values of some axes.
struct Corner {
    std::string title;
    SweepIndex at;
};
std::vector<Corner> corners_of(const std::vector<GridAxis>& axes) {
    std::vector<Corner> corners{Corner{}};
    for (const GridAxis& axis : axes) {
        std::vector<Corner> more;
        for (const Corner& corner : corners)
            for (std::size_t i = 0; i < axis.label.size(); ++i) {
                Corner next = corner;
                next.at.*axis.index = i;
                if (axis.label.size() > 1)
                    next.title += (next.title.empty() ? "" : ", ") + axis.label[i];
                more.push_back(std::move(next));
            }
        corners = std::move(more);
    }
    return corners;
}

/// At most `most` of them, equally spaced, the first and the last included.
template <typename Item>
std::vector<Item> picked(const std::vector<Item>& items, std::size_t most) {
    if (items.size() <= most) return items;
    std::vector<Item> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(items[i * (items.size() - 1) / (most - 1)]);
    return some;
}

double value_of(const SweepRow& row, const PlottedLevel& level, const Radar& radar) {
    if (level.column == "received_dbm") return row.level_db + radar.tx_power_dbm;
    if (level.column == "over_untilted_db") return row.over_untilted_db;
    if (level.column == "over_nominal_db") return row.over_nominal_db;
    return row.over_mirror_db;
}

/// The mirror that levels over height are compared with.
std::vector<LevelCurve> mirror_beside(const Sweep& sweep, const GridAxis& x,
                                      const PlottedLevel& level) {
    const Radar& radar = sweep.plan.scene.radar;
    const bool absolute = level.column == "received_dbm";
    if (x.index != &SweepIndex::height || !sweep.plan.frequencies_hz.empty() ||
        !(absolute || level.column == "over_nominal_db"))
        return {};
    LevelCurve curve{"infinite mirror", x.x, {}};
    const double nominal = mirror_transfer(radar, sweep.plan.scene.pose.height_m);
    for (const double height_m : sweep.plan.heights_m) {
        const double transfer = mirror_transfer(radar, height_m);
        curve.level.push_back(absolute ? radar.tx_power_dbm + 20.0 * std::log10(transfer)
                                       : 20.0 * std::log10(transfer / nominal));
    }
    return {curve};
}

std::string second_line(const SweepPlan& plan, const std::vector<GridAxis>& axes) {
    std::string text = plan.scene.radar.name;
    const auto add = [&](const std::string& more) { text += "; " + more; };
    if (plan.specimens.size() == 1) add(plan.specimens[0].label);
    for (std::size_t i = 1; i < axes.size(); ++i) {
        const bool idle_tilting = axes[i].index == &SweepIndex::tilting &&
                                  plan.tilts_rad.size() == 1 && plan.tilts_rad[0] == 0.0;
        if (axes[i].label.size() == 1 && !axes[i].label[0].empty() && !idle_tilting)
            add(axes[i].label[0]);
    }
    add(plan.frequencies_hz.empty() ? "mean over the chirp" : "at single frequencies");
    return text;
}

PlottedLevel level_of(const SweepPlan& plan, const GridAxis& x) {
    if (plan.plotted) return plotted_levels()[*plan.plotted];
    return plotted_levels()[x.index == &SweepIndex::height ? 0 : 1];
}

Figure figure_over(const Sweep& sweep, const GridAxis& x, const std::vector<GridAxis>& axes,
                   std::vector<std::string>& remarks) {
    const bool one_specimen = axes[0].label.size() == 1 && x.index != axes[1].index;
    const GridAxis& series = one_specimen ? axes[1] : axes[0];
    std::vector<GridAxis> rest;
    for (const GridAxis& axis : axes)
        if (axis.index != x.index && axis.index != series.index) rest.push_back(axis);
    const PlottedLevel level = level_of(sweep.plan, x);
    const std::string name = format("level_over_{}", x.name);
    LevelPanels content{sweep.plan.title, second_line(sweep.plan, axes), x.title, level.title, {}};
    const std::vector<LevelCurve> beside = mirror_beside(sweep, x, level);
    if (!beside.empty()) content.second_line += "; dashed: " + beside[0].label;
    const std::vector<Corner> corners = corners_of(rest);
    const std::size_t n_curves = std::min(series.label.size(), most_level_curves);
    if (n_curves < series.label.size())
        remarks.push_back(format("{} draws {} of {} curves", name, n_curves, series.label.size()));
    if (corners.size() > most_level_panels)
        remarks.push_back(
            format("{} draws {} of {} panels", name, most_level_panels, corners.size()));
    for (const Corner& corner : picked(corners, most_level_panels)) {
        LevelPanel panel{corner.title, {}, beside};
        SweepIndex at = corner.at;
        for (at.*series.index = 0; at.*series.index < n_curves; ++(at.*series.index)) {
            LevelCurve curve{series.label[at.*series.index], x.x, {}};
            for (at.*x.index = 0; at.*x.index < x.x.size(); ++(at.*x.index))
                curve.level.push_back(value_of(sweep.row(at), level, sweep.plan.scene.radar));
            panel.curves.push_back(std::move(curve));
        }
        content.panels.push_back(std::move(panel));
    }
    return level_figure(name, content);
}

}  // namespace

SweepFigures sweep_figures(const Sweep& sweep) {
    const std::vector<GridAxis> axes = axes_of(sweep.plan);
    SweepFigures drawn;
    for (const GridAxis& axis : axes)
        if (axis.x.size() > 1)
            drawn.figures.push_back(figure_over(sweep, axis, axes, drawn.remarks));
    return drawn;
}

}  // namespace specula
