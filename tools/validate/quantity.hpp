#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "materials/electrics.hpp"

namespace specula {

/// What a case may expect: nothing stands for a value that one side lacks.
using QuantityValue = std::variant<std::monostate, bool, double, Complex, std::string>;

/// One number of a point: what the program found beside what the case expects.
struct Quantity {
    std::string name;  ///< as the case calls it; elements of lists as "name[3]"
    QuantityValue computed;
    QuantityValue expected;
    double error = 0.0;      ///< >= 0, in `unit`; not-a-number misses every tolerance
    double tolerance = 0.0;  ///< >= 0, in `unit`
    std::string unit;        ///< "dB", "deg", "" where it is a plain number, "relative", ...
    bool judged = true;      ///< else only shown

    bool passes() const { return !judged || error <= tolerance; }
    /// Error over tolerance: above 1 where it is missed.
    double share() const {
        if (error == 0.0) return 0.0;
        const double ratio = error / tolerance;
        return std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
    }
};

}  // namespace specula
