#pragma once

#include <string>

#include "tools/validate/verdict.hpp"

namespace specula {

/// "2.3e-16 dB": an error or a tolerance with its unit.
struct ErrorText {
    double value;
    std::string unit;
    std::string text() const;
};

/// One line per case, then what failed and why, then the sum.
std::string validation_table(const Validation& validation);

/// "points[2] r_TE: error 0.1 over the tolerance of 0.01", or why it cannot be computed; empty for
/// a case that passes.
std::string complaint(const CaseVerdict& verdict);

/// "46 cases, 789 points: 26 pass, 0 fail, 20 cannot be computed".
std::string validation_sum(const Validation& validation);

}  // namespace specula
