#pragma once

#include <cstdint>
#include <string>

namespace specula {

struct Rgb {
    std::uint8_t red, green, blue;

    std::uint32_t packed() const {
        return (std::uint32_t{red} << 16) | (std::uint32_t{green} << 8) | blue;
    }
    std::string hex() const;  ///< "#rrggbb"
};

/// Colour of a share in [0, 1]: from paper white to dark blue, one hue, lightness falling linearly
/// in Oklab (Ottosson 2020). Equal steps look equal, in print and to colour-blind readers alike.
Rgb sequential_colour(double share);

/// Near-black or white, whichever reads better on `ground` (contrast ratio of WCAG 2.1).
Rgb text_colour_on(const Rgb& ground);

/// Contrast ratio of WCAG 2.1, from 1 to 21; body text needs 4.5.
double contrast_ratio(const Rgb& a, const Rgb& b);

}  // namespace specula
