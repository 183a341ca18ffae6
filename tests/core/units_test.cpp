#include "sim/core/units.hpp"

#include <map>
#include <numbers>
#include <set>
#include <string>

#include "tests/check.hpp"

namespace specula {
namespace {

const std::map<Unit, std::map<std::string, double>> expected{
    {Unit::length, {{"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}}},
    {Unit::angle, {{"rad", 1.0}, {"deg", std::numbers::pi / 180.0}}},
    {Unit::frequency, {{"hz", 1.0}, {"khz", 1e3}, {"mhz", 1e6}, {"ghz", 1e9}}},
    {Unit::time, {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"ps", 1e-12}}},
    {Unit::slope, {{"mhz_per_us", 1e12}, {"hz_per_s", 1.0}}},
    {Unit::conductivity, {{"s_per_m", 1.0}}},
    {Unit::voltage, {{"v", 1.0}, {"mv", 1e-3}}},
    {Unit::temperature, {{"k", 1.0}}},
    {Unit::density, {{"kg_per_m3", 1.0}, {"g_per_cm3", 1e3}}},
    {Unit::ratio_db, {{"db", 1.0}}},
    {Unit::power_dbm, {{"dbm", 1.0}}},
    {Unit::gain_dbi, {{"dbi", 1.0}}},
};

TEST_CASE("every suffix converts to SI by the factor of its name", "[units]") {
    for (const auto& [unit, factors] : expected) {
        std::map<std::string, double> found;
        for (const UnitSuffix& suffix : suffixes_of(unit))
            found.emplace(suffix.suffix, suffix.to_si);
        CHECK(found == factors);
        CHECK(found.size() == suffixes_of(unit).size());  // none twice
    }
}

TEST_CASE("no suffix belongs to two units", "[units]") {
    std::set<std::string_view> seen;
    std::size_t total = 0;
    for (const auto& [unit, factors] : expected)
        for (const UnitSuffix& suffix : suffixes_of(unit)) {
            seen.insert(suffix.suffix);
            ++total;
        }
    CHECK(seen.size() == total);
}

}  // namespace
}  // namespace specula
