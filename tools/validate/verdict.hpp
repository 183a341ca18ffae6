#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/validate/quantity.hpp"

namespace specula {

enum class Verdict { pass, fail, not_computable };
std::string verdict_name(Verdict verdict);  ///< "pass", "FAIL", "cannot compute"

struct PointVerdict {
    std::vector<Quantity> quantities;
    std::string problem;  ///< why it cannot be computed; else empty

    Verdict verdict() const;
    /// Of the judged quantities the one with the largest share of its tolerance; null where none
    /// is.
    const Quantity* worst() const;
};

struct CaseVerdict {
    std::string id, title, level, kind;
    std::filesystem::path path;
    std::vector<PointVerdict> points;

    /// A missed tolerance outweighs what cannot be computed.
    Verdict verdict() const;
    const Quantity* worst() const;
    std::size_t worst_point() const;
    std::size_t n_points_with(Verdict verdict) const;
    std::size_t n_shown_only() const;  ///< quantities that are not judged
};

struct Validation {
    std::filesystem::path folder;
    std::vector<CaseVerdict> cases;
    std::vector<std::string> others;  ///< files that are no cases

    std::size_t n_points() const;
    std::size_t n_cases_with(Verdict verdict) const;
    Verdict verdict() const;
    /// 0, 1 where a tolerance is missed, else 3 where something cannot be computed.
    int exit_status() const;
};

}  // namespace specula
