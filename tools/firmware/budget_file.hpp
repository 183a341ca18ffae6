#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/firmware/verification.hpp"

namespace specula {

/// Something that costs more than firmware/budget.toml allows.
struct Excess {
    std::string what;
    double spent = 0.0;
    double allowed = 0.0;
    std::string unit;
};

/// For which network and frame the budget file counts instructions, if for this one.
enum class BudgetShape {
    none,
    range_bins,  ///< 12-16-16-5 on range bins
    peak_shape,  ///< 25-32-32-5 on the shape of the peak: the study's remedy
};

/// The one of a frame and a model.
BudgetShape budget_shape_of(const VerifyInput& input);

/// What a verification spent beyond the budget. Sizes and stack hold always. Throws InputError for a
/// budget file that cannot be used.
std::vector<Excess> find_excess(const Verification& verification,
                                const std::filesystem::path& budget_file, BudgetShape shape);

}  // namespace specula
