#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/validate/case_kind.hpp"
#include "tools/validate/compare.hpp"

namespace specula {

/// How a level may be off, depending on how high it is expected.
struct LevelTolerance {
    double split_db;
    std::string above;  ///< key of the tolerance of levels above `split_db`
    std::string below;  ///< of the others; empty: they are shown, not judged
};

/// A tolerance that is no key of the case.
struct Allowed {
    double error;
    std::string unit;
};

/// Keys of what a channel may be off by.
struct ChannelTolerance {
    std::string level = "db";
    std::string phase = "phase_deg";
};

/// Sets what was computed for a point beside what the point expects.
///
/// Names that the point does not expect are passed over. Tolerances are keys of the case's
/// `tolerance`, which must hold them once they are needed. `finish` throws NotComputable if the
/// point holds anything, among what it gives or what it expects, that nobody asked for.
class Comparison {
  public:
    explicit Comparison(const CasePoint& point) : point_(point) {}

    bool wants(const std::string& name) const { return point_.expect.has(name); }

    void absolute(const std::string& name, Complex computed, const std::string& key);
    void relative(const std::string& name, Complex computed, const std::string& key);
    /// A level in dB, or a difference of levels.
    void level(const std::string& name, double computed_db, const std::string& key);
    void within(const std::string& name, double computed, const Allowed& allowed);
    void same(const std::string& name, double computed);
    void same_flag(const std::string& name, bool computed);

    /// A cyclic value, of which `turn` more or less is no error, near enough relative to its size.
    struct Cyclic {
        double value;
        double turn;
    };
    void wrapped(const std::string& name, const Cyclic& computed, const std::string& key);

    /// Lists, element by element.
    void absolute(const std::string& name, std::span<const double> computed, const std::string& key,
                  const std::string& unit);
    void levels(const std::string& name, std::span<const double> computed_db,
                const LevelTolerance& tolerance);
    void phases(const std::string& name, std::span<const double> computed_deg,
                double tolerance_deg);
    /// Two lists, real and imaginary part: the root of all squared errors over that of all squares.
    struct PartNames {
        std::string real, imaginary;
    };
    void whole(const PartNames& names, std::span<const Complex> computed, const std::string& key);

    /// A channel: `<prefix>h`, `<prefix>abs_db` and `<prefix>phase_deg`, by level and phase.
    void channel(const std::string& prefix, Complex h, const ChannelTolerance& allowed = {});

    /// A cross-section or another power, under its own name and under that of its level, both by
    /// level; levels below `floor_db` are all alike.
    struct PowerNames {
        std::string power, level;
    };
    struct Power {
        double value;
        double floor_db = -400.0;
    };
    void power(const PowerNames& names, const Power& computed, const std::string& key);

    /// Something the case does not list, held against a value found in another way.
    void additional(Quantity quantity) { add(std::move(quantity)); }

    /// A value whose expectation the caller has dug out of a list.
    void beside(const std::string& name, const NumberPair& values, const Allowed& allowed);

    /// What follows is only shown.
    void not_judged() { judged_ = false; }
    void judged_again() { judged_ = true; }
    /// Other values for a list of the case, only shown, under "name (how)".
    void show(const std::string& name, const std::string& how, std::span<const double> computed,
              const std::string& unit);
    /// Two angles in degrees, only shown.
    void show_angle(const std::string& name, const NumberPair& angles_deg);

    std::vector<Quantity> finish() const;

  private:
    void add(Quantity quantity);
    double tolerance(const std::string& key) const;
    /// Elements of a list; none, and an entry that says so, if there are not `n` of them.
    std::vector<double> expected_list(const std::string& name, std::size_t n);

    const CasePoint& point_;
    std::vector<Quantity> quantities_;
    bool judged_ = true;
};

}  // namespace specula
