#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/core/random.hpp"

namespace specula {

/// A value, or the law it is drawn from. In TOML, with the unit of the key:
/// `2.0`, `{ uniform = [a, b] }`, `{ normal = [mean, sd] }`, `{ factor = [median, ratio] }`,
/// `{ log_normal = [median, sd of the logarithm] }`, `{ choice = [a, b, ...] }`.
class Distribution {
  public:
    struct Fixed {
        double value = 0.0;
    };
    struct Uniform {
        double low, high;
    };
    struct Normal {
        double mean, sd;
    };
    /// Log-normal: median times or divided by about `ratio` (one standard deviation of the log).
    struct Factor {
        double median, ratio;
    };
    /// One of some values, each as likely.
    struct Choice {
        std::vector<double> values;  ///< at least one
    };
    using Law = std::variant<Fixed, Uniform, Normal, Factor, Choice>;

    Distribution(double value = 0.0) : law_(Fixed{value}) {}
    explicit Distribution(Law law) : law_(law) {}

    /// Advances the stream by the same amount whatever the law, so that changing one law in a file
    /// changes no other draw.
    double sample(Stream& stream) const;
    /// The value below which a share `u` of all draws lies, u in (0, 1).
    double quantile(double u) const;
    double median() const;
    /// The standard deviation (Factor: of the natural logarithm).
    double spread() const;
    const Law& law() const { return law_; }

  private:
    Law law_;
};

/// How the draws of several items are spread over a law.
enum class Sampling {
    random,      ///< independent of each other
    stratified,  ///< one in each of as many equally likely parts as there are items
    quasi,       ///< a low-discrepancy sequence: evenly spread, however many items there are
    grid,        ///< the values of a choice in turn
};

/// A law of a number that many items share. In TOML a law as above with `sampling = "..."` in it,
/// or `{ grid = [a, b, ...] }`.
struct SampledLaw {
    Distribution law;
    Sampling sampling = Sampling::random;
};

}  // namespace specula
