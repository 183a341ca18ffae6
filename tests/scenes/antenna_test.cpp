#include "scenes/antenna.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/reference_case.hpp"
#include "tests/scenes/decibel_of_power.hpp"

namespace specula {
namespace {

using namespace literals;

/// The direction at an azimuth and elevation of the radar's own frame.
Vector3 towards(double azimuth_rad, double elevation_rad) {
    return {std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad),
            -std::cos(elevation_rad) * std::cos(azimuth_rad)};
}

TEST_CASE("a patch radiates the power that its pattern integrates to", "[antenna][reference]") {
    const auto reference = reference_case("E02_pattern_norm");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        const PatchPattern patch{
            .gain_dbi = inp.at("G0_dbi"),
            .half_width_azimuth_rad = inp.at("az6_deg").get<double>() * pi / 180,
            .half_width_elevation_rad = inp.at("el6_deg").get<double>() * pi / 180};
        // Midpoint rule in z and the angle about it; in front, the pattern is smooth.
        constexpr int n = 300;
        double integral = 0.0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double z = -1.0 + 2.0 * (i + 0.5) / n, about = two_pi * (j + 0.5) / n;
                const double r = std::sqrt(1.0 - z * z);
                integral += patch.gain({r * std::cos(about), r * std::sin(about), z});
            }
        integral *= 2.0 / n * two_pi / n;
        CHECK(integral == Approx(point.at("expect").at("integral_G_dOmega")).epsilon(tolerance));
        CHECK(integral / (4.0 * pi) < 1.0);  // passive
    }
}

TEST_CASE("a patch has its gain ahead and a quarter of it at its half widths", "[antenna]") {
    const PatchPattern patch{
        .gain_dbi = 5.5, .half_width_azimuth_rad = 60.0_deg, .half_width_elevation_rad = 35.0_deg};
    constexpr double rounding = 1e-12;  // of a power and its logarithm
    CHECK(decibel_of_power(patch.gain(towards(0.0, 0.0))) == Approx(5.5).epsilon(rounding));
    for (const double sign : {-1.0, 1.0}) {
        CHECK(decibel_of_power(patch.gain(towards(sign * 60.0_deg, 0.0))) ==
              Approx(-0.5).epsilon(rounding));
        CHECK(decibel_of_power(patch.gain(towards(0.0, sign * 35.0_deg))) ==
              Approx(-0.5).epsilon(rounding));
    }
    // Azimuth and elevation multiply.
    CHECK(decibel_of_power(patch.gain(towards(60.0_deg, 35.0_deg))) ==
          Approx(-6.5).epsilon(rounding));
}

TEST_CASE("a patch radiates nothing sideways or behind, and no direction is not a number",
          "[antenna]") {
    const PatchPattern patch;
    for (const Vector3& direction :
         {Vector3(0.0, 0.0, 1.0), Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0),
          Vector3(0.0, -1.0, 0.0), Vector3(0.6, 0.0, 0.8)})
        CHECK(patch.gain(direction) == 0.0);
    CHECK(patch.gain(towards(89.999_deg, 0.0)) < 1e-8);
    CHECK(patch.gain(towards(0.0, 89.999_deg)) < 1e-30);
    CHECK(patch.gain({1e-300, 1.0, -1e-300}) == 0.0);
}

TEST_CASE("an isotropic antenna has one gain everywhere", "[antenna]") {
    const IsotropicPattern antenna{.gain_dbi = 3.0};
    for (const Vector3& direction : {towards(0.0, 0.0), towards(1.0, -1.0), Vector3(0.0, 0.0, 1.0)})
        CHECK(decibel_of_power(antenna.gain(direction)) == Approx(3.0).epsilon(1e-12));
    CHECK(gain_towards(Pattern(IsotropicPattern{}), towards(0.3, 0.2)) == 1.0);
}

TEST_CASE("the field pattern is transverse, along y as far as it can, and squares to the gain",
          "[antenna]") {
    const Pattern pattern = PatchPattern{};
    for (const double azimuth_rad : {-1.2, 0.0, 0.7})
        for (const double elevation_rad : {-1.0, 0.0, 0.4}) {
            const Vector3 direction = towards(azimuth_rad, elevation_rad);
            const Vector3 field = field_pattern(pattern, direction);
            constexpr double rounding = 1e-14;
            CHECK(std::abs(field.dot(direction)) < rounding);
            CHECK(field.squaredNorm() ==
                  Approx(gain_towards(pattern, direction)).epsilon(rounding));
            CHECK(field.y() > 0.0);
            // In the plane of y and the direction: nothing along their normal.
            CHECK(std::abs(field.dot(Vector3::UnitY().cross(direction))) < rounding);
        }
    CHECK(field_pattern(pattern, towards(0.0, 0.0)).normalized() == Vector3(0.0, 1.0, 0.0));
    CHECK(field_pattern(Pattern(IsotropicPattern{}), {0.0, 1.0, 0.0}) == Vector3::Zero());
}

TEST_CASE("the field pattern for many directions is that for one, turned", "[antenna]") {
    const Rotation rotation(Eigen::AngleAxisd(0.4, Vector3(1.0, -2.0, 0.5).normalized()));
    for (const Pattern& pattern : {Pattern(PatchPattern{}), Pattern(IsotropicPattern{2.0})}) {
        const FieldPattern fields(pattern, rotation);
        for (const double azimuth_rad : {-1.2, 0.0, 0.7, 2.0}) {
            const Vector3 own = towards(azimuth_rad, 0.3);
            const Vector3 expected = rotation * field_pattern(pattern, own);
            CHECK((fields(rotation * own) - expected).norm() < 1e-14);
        }
    }
}

TEST_CASE("an antenna section is read by its pattern", "[antenna]") {
    const auto read = [](const std::string& text) {
        Section section = Section::parse(text, "x.toml");
        Pattern pattern = read_kind<Pattern>(section, "pattern");
        section.finish();
        return pattern;
    };
    const Pattern patch = read(
        "pattern = 'patch'\ngain_dbi = 5.5\nhalf_width_azimuth_deg = 60\n"
        "half_width_elevation_deg = 35");
    CHECK(decibel_of_power(gain_towards(patch, towards(0.0, 35.0_deg))) == Approx(-0.5));
    CHECK(message_of([&] {
              return read("pattern = 'isotropic'\ngain_dbi = 0\nhalf_width_azimuth_deg = 60");
          }) == "x.toml:3: half_width_azimuth_deg = 60: is not a key of this file; remove it");
    CHECK(message_of([&] {
              return read("pattern = 'patch'\ngain_dbi = 0\nhalf_width_azimuth_deg = 90\n");
          }) ==
          "x.toml:3: half_width_azimuth_deg = 90: is out of range; "
          "give a value above 0 deg and below 90 deg");
}

}  // namespace
}  // namespace specula
