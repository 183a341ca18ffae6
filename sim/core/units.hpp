#pragma once

#include <span>
#include <string_view>

namespace specula {

/// What a quantity measures. In a TOML file the unit is the end of the key: `height_mm`.
enum class Unit {
    length,
    angle,
    frequency,
    time,
    slope,         ///< chirp slope
    conductivity,  ///< S/m
    voltage,
    speed,
    temperature,
    density,
    ratio_db,
    power_dbm,
    gain_dbi,
};

struct UnitSuffix {
    std::string_view suffix;  ///< end of the key, e.g. "mm"
    double to_si;             ///< value in SI = value in the file * to_si
};

/// The suffixes accepted for a dimension; the first is the one that messages suggest.
std::span<const UnitSuffix> suffixes_of(Unit unit);

}  // namespace specula
