#include "scenes/antenna_table.hpp"

#include <cmath>

#include "scenes/antenna.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/scenes/decibel_of_power.hpp"

namespace specula {
namespace {

constexpr double rad_per_deg = pi / 180.0;

Vector3 towards_deg(double azimuth_deg, double elevation_deg) {
    const double a = azimuth_deg * rad_per_deg, e = elevation_deg * rad_per_deg;
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

/// A patch as a table over most of the half space in front.
std::string table_of(const PatchPattern& patch, double step_deg, double lift_db) {
    std::string text = "azimuth_deg,elevation_deg,gain_dbi\n";
    for (double e = -85.0; e <= 85.0; e += step_deg)
        for (double a = -85.0; a <= 85.0; a += step_deg)
            text += format("{},{},{}\n", a, e,
                           decibel_of_power(patch.gain(towards_deg(a, e))) + lift_db);
    return text;
}

TEST_CASE("a patch sampled every 5 degrees is the patch within its interpolation", "[antenna]") {
    const MadeUpFolder folder;
    const PatchPattern patch;
    const auto file = folder.with("patch.csv", table_of(patch, 5.0, 0.0));
    const TablePattern table = read_antenna_table(file);
    for (const double a : {-31.0, -5.0, 0.0, 12.5, 44.0})
        for (const double e : {-22.0, 0.0, 2.5, 20.0})
            // Straight lines in dB: step^2/8 times the curvature 4.3 n / cos^2, n = 6.9, at most.
            CHECK(decibel_of_power(table.gain(towards_deg(a, e)) / patch.gain(towards_deg(a, e))) ==
                  Approx(0.0).margin(0.05));
    CHECK(table.gain(towards_deg(0.0, 89.0)) == 0.0);
    CHECK(table.gain(towards_deg(180.0, 0.0)) == 0.0);
    CHECK(radiated_share(table) == Approx(radiated_share(patch)).epsilon(0.01));
}

TEST_CASE("a table's faults are told by line", "[antenna]") {
    const MadeUpFolder folder;
    const auto refusal = [&](const std::string& text) {
        const auto file = folder.with("bad.csv", text);
        return message_of([&] { read_antenna_table(file); });
    };
    const auto says = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    CHECK(says(refusal("0,0,5\n1,0,x\n"), "bad.csv:2: \"x\" is not a number"));
    CHECK(says(refusal("0,0,nan\n"), "not a number"));
    CHECK(says(refusal("0,0\n"), "bad.csv:1: 2 values"));
    CHECK(says(refusal("0,95,1\n"), "no direction"));
    CHECK(says(refusal("0,0,90\n"), "90 dBi"));
    CHECK(says(refusal("0,0,1\n0,0,2\n"), "bad.csv:2: the direction stands there twice"));
    CHECK(says(refusal("0,0,1\n1,0,1\n0,1,1\n2,1,1\n"), "other azimuths"));
    CHECK(says(refusal("1,1,1\n2,1,1\n1,2,1\n2,2,1\n"), "boresight"));
    CHECK(says(refusal(""), "no grid"));
    CHECK(says(message_of([] { read_antenna_table("/nowhere/a.csv"); }), "cannot be read"));
    CHECK(refusal("-1,-1,1\n1,-1,1\n-1,1,1\n1,1,1\n") == "(no error)");
}

TEST_CASE("an antenna that radiates more than it is fed is refused", "[antenna]") {
    const MadeUpFolder folder;
    folder.with("loud.csv", table_of({}, 5.0, 6.0));
    const auto file = folder.with("radar.toml", "file = \"loud.csv\"\n");
    CHECK(message_of([&] {
              Section section = Section::read(file);
              TablePattern::read(section);
          }).find("radar.toml:1: file") != std::string::npos);
    Section narrow = Section::parse(
        "gain_dbi = 14\nhalf_width_azimuth_deg = 60\nhalf_width_elevation_deg = 35\n", "n.toml");
    CHECK(message_of([&] { PatchPattern::read(narrow); }).find("n.toml:1: gain_dbi") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
