#include "firmware/fw_log.h"

#include <cfloat>
#include <cmath>
#include <limits>

#include "tests/check.hpp"

namespace {

/// Distance from the true logarithm in units of the last place of the result.
double log_error_ulp(float x) {
    const double exact = std::log(static_cast<double>(x));
    const double ulp = std::ldexp(1.0, std::max(std::ilogb(exact), -126) - 23);
    return std::abs(static_cast<double>(fw_log(x)) - exact) / ulp;
}

}  // namespace

TEST_CASE("the logarithm is within 1.5 ulp over all normal numbers", "[firmware]") {
    double worst = 0;
    for (float x = FLT_MIN; x < FLT_MAX / 1.0002F; x *= 1.0001F)
        worst = std::max(worst, log_error_ulp(x));
    // Around 1, where the result passes through 0 and a careless sum would cancel.
    for (float x = 0.5F; x < 2.0F; x = std::nextafter(x, 2.0F) + 1e-6F) {
        if (x != 1.0F) worst = std::max(worst, log_error_ulp(x));
    }
    CAPTURE(worst);
    CHECK(worst < 1.5);
    CHECK(worst > 0.5);  // a correctly rounded one would mean that the test sees nothing
}

TEST_CASE("the logarithm never leaves the finite numbers", "[firmware]") {
    CHECK(fw_log(1.0F) == 0.0F);
    CHECK(fw_log(0.0F) == fw_log(FLT_MIN));
    CHECK(fw_log(-1.0F) == fw_log(FLT_MIN));
    CHECK(fw_log(FLT_MIN / 8) == fw_log(FLT_MIN));
    CHECK(fw_log(std::numeric_limits<float>::infinity()) == fw_log(FLT_MAX));
    CHECK(std::isnan(fw_log(std::numeric_limits<float>::quiet_NaN())));
}
