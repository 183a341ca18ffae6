#include "classifier/mixing.hpp"

#include <cmath>

#include "sim/core/expect.hpp"

namespace specula {

double mixing_share(double shape, Stream& stream) {
    SPECULA_EXPECT(shape >= 0.05 && shape <= 1.0);  // below, the powers underflow
    while (true) {
        const double a = std::pow(stream.uniform(), 1.0 / shape);
        const double b = std::pow(stream.uniform(), 1.0 / shape);
        if (a + b <= 1.0) return a / (a + b);
    }
}

}  // namespace specula
