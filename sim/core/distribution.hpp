#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/core/random.hpp"

namespace specula {

/// A value, or the law it is drawn from. In TOML, with the unit of the key:
/// `2.0`, `{ uniform = [a, b] }`, `{ normal = [mean, sd] }`, `{ factor = [median, ratio] }`.
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
    using Law = std::variant<Fixed, Uniform, Normal, Factor>;

    Distribution(double value = 0.0) : law_(Fixed{value}) {}
    explicit Distribution(Law law) : law_(law) {}

    /// Advances the stream by the same amount whatever the law, so that changing one law in a file
    /// changes no other draw.
    double sample(Stream& stream) const;
    double median() const;
    /// The standard deviation (Factor: of the natural logarithm).
    double spread() const;
    const Law& law() const { return law_; }

  private:
    Law law_;
};

}  // namespace specula
