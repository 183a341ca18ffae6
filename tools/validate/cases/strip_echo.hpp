#pragma once

#include "sim/channel/reflector.hpp"
#include "sim/trace/scatter.hpp"
#include "tools/validate/fields.hpp"

namespace specula {

/// A strip, infinite along y, and a line source above it: a world of two dimensions.
struct StripScene {
    double width_m;
    double height_m;  ///< of the source above the untilted strip
    double tilt_rad;  ///< about the middle of the strip
    double frequency_hz;
};

/// `H_m`, `tilt_deg`, `f_hz`, and the width under one of its names.
StripScene strip_scene_of(const Fields& inp, std::initializer_list<const char*> width_names);

enum class LinePolarisation { tm, te };  ///< E along the strip, or across it
std::string polarisation_name(LinePolarisation polarisation);

/// What the strip sends back to its line source, over the return of an infinite perfect conductor
/// at the same height, worked out by the tracer on a strip that is long but not infinite.
/// @eq PHYSICS.md#line-source
class StripEcho {
  public:
    struct Options {
        LinePolarisation polarisation;
        double reach = 4.0;  ///< to where the strip is traced, over the distance of its rim
    };
    StripEcho(const StripScene& scene, const Options& options);

    Complex of(const Reflector& reflector) const;  ///< by physical optics alone
    Complex with_edge_currents(const Reflector& reflector) const;

  private:
    Complex over_mirror(const Scatter& scatter, const Reflector& reflector) const;

    StripScene scene_;
    Scatter scatter_;
};

}  // namespace specula
