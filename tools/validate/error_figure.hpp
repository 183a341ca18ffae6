#pragma once

#include <string>
#include <vector>

#include "tools/report/figure.hpp"
#include "tools/validate/verdict.hpp"

namespace specula {

/// Error over tolerance of every point of some cases, beside each other, on a logarithmic axis.
Figure error_figure(const std::string& name, const std::string& title,
                    const std::vector<const CaseVerdict*>& cases);

}  // namespace specula
