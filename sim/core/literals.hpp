#pragma once

#include "sim/core/constants.hpp"

/// Units at call sites and in tests: `5.0_mm`, `60.0_GHz`. Never in headers.
namespace specula::literals {

constexpr double operator""_m(long double v) {
    return static_cast<double>(v);
}
constexpr double operator""_cm(long double v) {
    return static_cast<double>(v) * 1e-2;
}
constexpr double operator""_mm(long double v) {
    return static_cast<double>(v) * 1e-3;
}
constexpr double operator""_um(long double v) {
    return static_cast<double>(v) * 1e-6;
}
constexpr double operator""_GHz(long double v) {
    return static_cast<double>(v) * 1e9;
}
constexpr double operator""_MHz(long double v) {
    return static_cast<double>(v) * 1e6;
}
constexpr double operator""_deg(long double v) {
    return static_cast<double>(v) * pi / 180.0;
}

}  // namespace specula::literals
