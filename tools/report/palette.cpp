#include "tools/report/palette.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {
namespace {

constexpr Rgb dark_text{0x05, 0x05, 0x05};  // not black: that would follow the page (inline_svg)
constexpr Rgb light_text{0xff, 0xff, 0xff};

std::uint8_t encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * s));
}

double linear(std::uint8_t code) {
    const double s = code / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double luminance(const Rgb& c) {
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

/// Oklab to sRGB: B. Ottosson, "A perceptual color space for image processing", 2020.
Rgb from_oklab(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

std::string Rgb::hex() const {
    return format("#{:02x}{:02x}{:02x}", red, green, blue);
}

Rgb sequential_colour(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    const double lightness = 0.980 - 0.650 * t;
    const double chroma = 0.004 + 0.118 * std::sin(pi * (0.75 * t));  // stays inside sRGB
    const double hue = 250.0 * pi / 180.0;
    return from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

double contrast_ratio(const Rgb& a, const Rgb& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

Rgb text_colour_on(const Rgb& ground) {
    return contrast_ratio(ground, light_text) > contrast_ratio(ground, dark_text) ? light_text
                                                                                  : dark_text;
}

}  // namespace specula
