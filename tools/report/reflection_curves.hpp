#pragma once

#include "materials/material.hpp"
#include "tools/report/reflection_figure.hpp"

namespace specula {

/// What a smooth face of a material in air reflects: half-space and sheets head-on from 57 to
/// 64 GHz, along and across a grain; half-space and sheet over all angles at 60 GHz.
ReflectionCurves reflection_curves(const Material& material);

}  // namespace specula
