#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/provenance.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Reflected power over that of a mirror.
struct ReflectionCurve {
    std::string label;
    std::vector<double> x;         ///< GHz or degrees
    std::vector<double> level_db;  ///< as long
};

struct ReflectionCurves {
    std::string title, second_line;
    std::vector<ReflectionCurve> over_frequency;  ///< head-on; at most seven, over one band
    std::vector<ReflectionCurve> over_angle;      ///< at one frequency; drawn firmly
    std::vector<ReflectionCurve> beside;          ///< over angle too; drawn finely, same colours
    std::string angle_title;                      ///< what the angle panel shows
    std::optional<double> brewster_deg;           ///< marked where it is given
    FrequencyBand valid;                          ///< frequencies outside are shaded
};

/// Two panels: what a material reflects over frequency, and over the angle of incidence.
Figure reflection_figure(const std::string& name, const ReflectionCurves& content);

}  // namespace specula
