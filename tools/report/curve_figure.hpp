#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/report/figure.hpp"

namespace specula {

struct Curve {
    std::string label{};
    std::vector<double> x{}, y{};
    std::vector<double> low{}, high{};  ///< a band about it; empty: none
    bool points_only = false;
    std::size_t colour = 0;  ///< number of the series, so that panels agree
};

struct CurvePanel {
    std::string x_title{};
    std::array<double, 2> x_range{};
    std::vector<Curve> curves{};
    bool diagonal = false;                        ///< a line of equal values
    std::optional<std::array<double, 2>> star{};  ///< the paper's place
};

struct CurveContent {
    std::string title{}, second_line{}, y_title{};
    std::array<double, 2> y_range{0.0, 100.0};
    std::vector<CurvePanel> panels{};  ///< one to three, beside each other
};

/// Curves with their bands, markers at the points; the legend names each label once. y is in
/// percent; the table of the data holds shares.
Figure curve_figure(const std::string& name, const CurveContent& content);

}  // namespace specula
