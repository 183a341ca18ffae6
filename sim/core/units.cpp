#include "sim/core/units.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr UnitSuffix length[] = {{"mm", 1e-3}, {"m", 1.0}, {"cm", 1e-2}, {"um", 1e-6}};
constexpr UnitSuffix angle[] = {{"deg", pi / 180.0}, {"rad", 1.0}};
constexpr UnitSuffix frequency[] = {{"ghz", 1e9}, {"mhz", 1e6}, {"khz", 1e3}, {"hz", 1.0}};
constexpr UnitSuffix time[] = {{"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}, {"ns", 1e-9}, {"ps", 1e-12}};
constexpr UnitSuffix slope[] = {{"mhz_per_us", 1e12}, {"hz_per_s", 1.0}};
constexpr UnitSuffix conductivity[] = {{"s_per_m", 1.0}};
constexpr UnitSuffix voltage[] = {{"v", 1.0}, {"mv", 1e-3}};
constexpr UnitSuffix speed[] = {{"mm_per_s", 1e-3}, {"m_per_s", 1.0}};
constexpr UnitSuffix temperature[] = {{"k", 1.0}};
constexpr UnitSuffix density[] = {{"kg_per_m3", 1.0}, {"g_per_cm3", 1e3}};
constexpr UnitSuffix ratio_db[] = {{"db", 1.0}};
constexpr UnitSuffix power_dbm[] = {{"dbm", 1.0}};
constexpr UnitSuffix gain_dbi[] = {{"dbi", 1.0}};

}  // namespace

std::span<const UnitSuffix> suffixes_of(Unit unit) {
    switch (unit) {
        case Unit::length:
            return length;
        case Unit::angle:
            return angle;
        case Unit::frequency:
            return frequency;
        case Unit::time:
            return time;
        case Unit::slope:
            return slope;
        case Unit::conductivity:
            return conductivity;
        case Unit::voltage:
            return voltage;
        case Unit::speed:
            return speed;
        case Unit::temperature:
            return temperature;
        case Unit::density:
            return density;
        case Unit::ratio_db:
            return ratio_db;
        case Unit::power_dbm:
            return power_dbm;
        case Unit::gain_dbi:
            return gain_dbi;
    }
    SPECULA_EXPECT(!"a unit without suffixes");
    return {};
}

}  // namespace specula
