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

/// What a verification spent beyond the budget. Instruction budgets hold for the default network
/// and frame, so the caller asks only then; sizes and stack hold always. Throws InputError for a
/// budget file that cannot be used.
std::vector<Excess> find_excess(const Verification& verification,
                                const std::filesystem::path& budget_file, bool default_shape);

}  // namespace specula
