#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/validate/case_kind.hpp"

namespace specula {

/// How a level may be off, depending on how high it is expected.
struct LevelTolerance {
    double split_db;
    std::string above;  ///< key of the tolerance of levels above `split_db`
    std::string below;  ///< of the others; empty: they are shown, not judged
};

/// Sets what was computed for a point beside what the point expects.
///
/// Names that the point does not expect are passed over. Tolerances are keys of the case's
/// `tolerance`; where none fits, a number may be given. `finish` throws NotComputable if the point
/// holds anything, among what it gives or what it expects, that nobody asked for.
class Comparison {
  public:
    explicit Comparison(const CasePoint& point) : point_(point) {}

    bool wants(const std::string& name) const { return point_.expect.has(name); }

    void absolute(const std::string& name, Complex computed, const std::string& key);
    void relative(const std::string& name, Complex computed, const std::string& key);
    /// A level in dB, or a difference of levels.
    void level(const std::string& name, double computed_db, const std::string& key);
    void within(const std::string& name, double computed, double tolerance,
                const std::string& unit);
    void exact(const std::string& name, double computed);
    void exact(const std::string& name, bool computed);
    /// An angle in degrees; a turn more or less is no error.
    void phase(const std::string& name, double computed_deg, double tolerance_deg);
    /// An angle in radians or a share of a turn, near enough relative to its size; whole `turn`s
    /// are no error.
    void wrapped(const std::string& name, double computed, double turn, const std::string& key);

    void absolute(const std::string& name, std::span<const double> computed,
                  const std::string& key, const std::string& unit);
    void levels(const std::string& name, std::span<const double> computed_db,
                const LevelTolerance& tolerance);
    void phases(const std::string& name, std::span<const double> computed_deg,
                double tolerance_deg);
    /// The root of the summed squares of all errors, over that of what is expected; in two lists.
    void whole(const std::string& real_name, const std::string& imaginary_name,
               std::span<const Complex> computed, const std::string& key);

    /// A channel: `<prefix>h`, `<prefix>abs_db` and `<prefix>phase_deg`, by level and phase.
    void channel(const std::string& prefix, Complex h);

    /// What follows is only shown.
    void not_judged() { judged_ = false; }

    std::vector<Quantity> finish() const;

  private:
    void add(Quantity quantity);
    double tolerance(const std::string& key) const;
    /// Elements of a list, or an entry that says that the lengths differ.
    std::vector<double> expected_list(const std::string& name, std::size_t n);

    const CasePoint& point_;
    std::vector<Quantity> quantities_;
    bool judged_ = true;
};

}  // namespace specula
