#pragma once

#include "tools/likeness/likeness.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// A row per RX: mean chirp, spectrum, noise and histogram, recorded and simulated.
Figure likeness_figure(const Likeness& likeness, const std::string& title);

}  // namespace specula
