#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/section_of.hpp"

namespace specula {
namespace {

std::string length_error(const std::string& text, Range range) {
    return message_of([&] { return section_of(text).quantity("height", Unit::length, range); });
}

TEST_CASE("a quantity is the same under every suffix of its unit", "[document][quantity]") {
    constexpr double ulp = 2.3e-16;  // the factor of the suffix is rounded, and the product is
    for (const char* text : {"height_mm = 450", "height_m = 0.45", "height_cm = 45.0",
                             "height_um = 450_000", "height_mm = 4.5e2"})
        CHECK(section_of(text).quantity("height", Unit::length, Range::any()) ==
              Approx(0.45).epsilon(ulp));
    CHECK(section_of("tilt_deg = 180").quantity("tilt", Unit::angle, Range::any()) == Approx(pi));
    CHECK(section_of("slope_mhz_per_us = 150").quantity("slope", Unit::slope, Range::any()) ==
          150e12);
    CHECK(section_of("gain_db = -3").quantity("gain", Unit::ratio_db, Range::any()) == -3.0);
}

TEST_CASE("a fallback of a quantity is in SI and only for a missing one", "[document][quantity]") {
    CHECK(section_of("").quantity("height", Unit::length, Range::any(), 0.45) == 0.45);
    CHECK_THROWS_AS(
        section_of("height_mm = 'x'").quantity("height", Unit::length, Range::any(), 0.45),
        InputError);
    CHECK(section_of("").distribution("height", Unit::length, Range::any(), 0.45).median() == 0.45);
    CHECK_FALSE(section_of("height_deg = 1").has_quantity("height", Unit::length));
    CHECK(section_of("height_um = 1").has_quantity("height", Unit::length));
}

TEST_CASE("one quantity in two units is refused", "[document][quantity]") {
    CHECK(length_error("height_mm = 450\nheight_m = 0.45", Range::any()) ==
          "x.toml:2: height_m = 0.45: is given twice, as height_mm too; keep one of them");
    CHECK(message_of([] {
              return section_of("[a]\nheight_mm = 1\nheight_cm = 1")
                  .section("a")
                  .quantity("height", Unit::length, Range::any(), 1.0);
          }) == "x.toml:3: a.height_cm = 1: is given twice, as a.height_mm too; keep one of them");
}

TEST_CASE("a missing quantity is asked for in its first unit", "[document][quantity]") {
    CHECK(length_error("", Range::any()) == "x.toml:1: height_mm: is missing; add it");
    CHECK(length_error("a = 1\nheigth_cm = 4", Range::any()) ==
          "x.toml:1: height_cm: is missing; add it, or is it meant by heigth_cm in line 2?");
}

TEST_CASE("a quantity without a unit, or with one of another kind, is told its units",
          "[document][quantity]") {
    CHECK(length_error("\nheight = 450", Range::any()) ==
          "x.toml:2: height = 450: has no unit; "
          "write height_mm, height_m, height_cm or height_um");
    const auto optional_tilt = [](const std::string& text) {
        return message_of([&] {
            Section section = section_of(text);
            (void)section.quantity("tilt", Unit::angle, Range::any(), 0.0);
            (void)section.text("tilted", "");
            section.finish();
            return 0;
        });
    };
    CHECK(optional_tilt("tilt = 10") ==
          "x.toml:1: tilt = 10: has no unit; "
          "write tilt_deg or tilt_rad");
    CHECK(optional_tilt("tilt_degrees = 10") ==
          "x.toml:1: tilt_degrees = 10: is not a key of this file; did you mean tilt_deg?");
    CHECK(optional_tilt("tilt_mm = 10") ==
          "x.toml:1: tilt_mm = 10: is not a key of this file; "
          "if it is a unit, write tilt_deg or tilt_rad");
}

TEST_CASE("a range is told in the unit of the key", "[document][quantity]") {
    CHECK(length_error("height_mm = -3", Range::above(0.0)) ==
          "x.toml:1: height_mm = -3: is out of range; give a value above 0 mm");
    CHECK(length_error("height_m = 11", Range::between(0.001, 10.0)) ==
          "x.toml:1: height_m = 11: is out of range; "
          "give a value at least 0.001 m and at most 10 m");
    CHECK(length_error("height_cm = 1001", Range::inside(0.0, 10.0)) ==
          "x.toml:1: height_cm = 1001: is out of range; give a value above 0 cm and below 1000 cm");
    CHECK(length_error("height_mm = 'tall'", Range{.max = 2.0}) ==
          "x.toml:1: height_mm = \"tall\": is not a number; give a number at most 2000 mm");
    CHECK(message_of([] {
              return section_of("t_deg = 95")
                  .quantity("t", Unit::angle, Range::between(-pi, 85 * pi / 180));
          }) ==
          "x.toml:1: t_deg = 95: is out of range; "
          "give a value at least -180 deg and at most 85 deg");
}

TEST_CASE("a value at the stated bound is taken, in every unit", "[document][quantity]") {
    for (const double bound : {85.0 * pi / 180.0, pi, two_pi, 0.2})
        for (const UnitSuffix& suffix : suffixes_of(Unit::angle)) {
            const std::string key = "t_" + std::string(suffix.suffix);
            const auto read = [&](const std::string& value) {
                return section_of(key + " = " + value)
                    .quantity("t", Unit::angle, Range::between(-bound, bound));
            };
            const std::string told = message_of([&] { return read("1e3"); });
            const std::string at_most = "at most ";
            const auto from = told.find(at_most) + at_most.size();
            const std::string value = told.substr(from, told.find(' ', from) - from);
            INFO(told);
            CHECK(read(value) == Approx(bound).epsilon(1e-9));
            CHECK(read("-" + value) == Approx(-bound).epsilon(1e-9));
        }
    struct Bound {
        double bound_m;
        const char* text;
    };
    for (const auto& [bound_m, text] :
         {Bound{10.0, "h_mm = 10_000"}, Bound{0.1, "h_um = 100_000"}, Bound{0.05, "h_mm = 50"},
          Bound{0.05, "h_um = 50_000"}, Bound{0.05, "h_cm = 5"}, Bound{0.002, "h_um = 2000"},
          Bound{0.002, "h_cm = 0.2"}, Bound{1e-3, "h_um = 1000"}, Bound{0.3, "h_cm = 30"}})
        CHECK(section_of(text).quantity("h", Unit::length, Range::between(0.0, bound_m)) ==
              Approx(bound_m));
}

TEST_CASE("an excluded bound is out of range, its neighbour is in", "[document][quantity]") {
    CHECK_THROWS_AS(section_of("h_m = 0").quantity("h", Unit::length, Range::above(0.0)),
                    InputError);
    CHECK_THROWS_AS(section_of("h_m = 2").quantity("h", Unit::length, Range::inside(0.0, 2.0)),
                    InputError);
    CHECK(section_of("h_m = 0").quantity("h", Unit::length, Range::at_least(0.0)) == 0.0);
    CHECK(section_of("h_m = 1e-300").quantity("h", Unit::length, Range::above(0.0)) == 1e-300);
    CHECK_THROWS_AS(section_of("t_deg = 90").quantity("t", Unit::angle, Range::inside(0.0, pi / 2)),
                    InputError);
}

TEST_CASE("what is not a finite number is in no range", "[document][quantity]") {
    for (const char* value : {"nan", "-nan", "inf", "-inf", "+inf"})
        for (const Range& range : {Range::any(), Range::at_least(0.0), Range::between(-1.0, 1.0)}) {
            const std::string message = length_error(std::string("height_mm = ") + value, range);
            CHECK(message.find(": is not a finite number; give a value ") != std::string::npos);
        }
    CHECK(length_error("height_mm = nan", Range::any()) ==
          "x.toml:1: height_mm = nan: is not a finite number; give a value that is finite");
    // Finite as written, but not in SI.
    CHECK_THROWS_AS(section_of("f_ghz = 1e308").quantity("f", Unit::frequency, Range::any()),
                    InputError);
    CHECK_THROWS_AS(section_of("v = nan").number("v", Range::any()), InputError);
    CHECK_FALSE(Range::any().holds(std::nan("")));
    CHECK_FALSE(Range::any().holds(INFINITY));
}

TEST_CASE("lists of quantities are in the unit of their key", "[document][quantity]") {
    CHECK(section_of("size_mm = [300, 200.5]")
              .quantities("size", Unit::length, 2, Range::above(0.0)) ==
          std::vector<double>{300 * 1e-3, 200.5 * 1e-3});
    CHECK(message_of([] {
              return section_of("size_mm = [300, 0]")
                  .quantities("size", Unit::length, 2, Range::above(0.0));
          }) == "x.toml:1: size_mm = [300, 0]: is out of range; give a value above 0 mm");
    CHECK(message_of([] {
              return section_of("size_mm = 300")
                  .quantities("size", Unit::length, 2, Range::above(0.0));
          }) ==
          "x.toml:1: size_mm = 300: is not a list of the right length; give 2 numbers: [...]");
}

Distribution length_law(const std::string& value) {
    return section_of("d_mm = " + value).distribution("d", Unit::length, Range::inside(0.0, 1.0));
}

std::string law_error(const std::string& value) {
    return message_of([&] { return length_law(value); });
}

TEST_CASE("laws are read in the unit of the key, their ratios without one", "[document][law]") {
    CHECK(std::get<Distribution::Fixed>(length_law("2").law()).value == 2e-3);
    const auto uniform = std::get<Distribution::Uniform>(length_law("{ uniform = [1, 3] }").law());
    CHECK(uniform.low == 1e-3);
    CHECK(uniform.high == 3e-3);
    const auto normal = std::get<Distribution::Normal>(length_law("{ normal = [5, 0.1] }").law());
    CHECK(normal.mean == 5e-3);
    CHECK(normal.sd == Approx(1e-4));
    const auto factor = std::get<Distribution::Factor>(length_law("{ factor = [5, 1.5] }").law());
    CHECK(factor.median == 5e-3);
    CHECK(factor.ratio == 1.5);
    const auto plain =
        section_of("f = { factor = [2, 1.5] }").factor("f", Range::inside(0.5, 3.0), 1.0).law();
    CHECK(std::get<Distribution::Factor>(plain).median == 2.0);
    CHECK(section_of("").factor("f", Range::any(), 1.0).median() == 1.0);
}

TEST_CASE("laws that cannot be are refused with what they want", "[document][law]") {
    CHECK(law_error("{ uniform = [3, 1] }") ==
          "x.toml:1: d_mm.uniform = [3, 1]: runs backwards; put the smaller value first");
    CHECK(law_error("{ uniform = [0, 1] }") ==
          "x.toml:1: d_mm.uniform = [0, 1]: is out of range; "
          "give a value above 0 mm and below 1000 mm");
    CHECK(law_error("{ uniform = [1] }") ==
          "x.toml:1: d_mm.uniform = [1]: is not a list of the right length; give 2 numbers: [...]");
    CHECK(law_error("{ normal = [5, -1] }") ==
          "x.toml:1: d_mm.normal = [5, -1]: is out of range; give [mean, standard deviation]: "
          "a mean above 0 mm and below 1000 mm, a standard deviation at least 0");
    CHECK(law_error("{ normal = [-5, 1] }") ==
          "x.toml:1: d_mm.normal = [-5, 1]: is out of range; give [mean, standard deviation]: "
          "a mean above 0 mm and below 1000 mm, a standard deviation at least 0");
    CHECK(law_error("{ normal = [5, nan] }") ==
          "x.toml:1: d_mm.normal = [5, nan]: is not a finite number; give a value that is finite");
    CHECK(law_error("{ factor = [5, 0.9] }") ==
          "x.toml:1: d_mm.factor = [5, 0.9]: is out of range; give [median, ratio]: "
          "a median above 0 mm and below 1000 mm, a ratio at least 1");
    CHECK(law_error("{ factor = [2000, 1.1] }") ==
          "x.toml:1: d_mm.factor = [2000, 1.1]: is out of range; give [median, ratio]: "
          "a median above 0 mm and below 1000 mm, a ratio at least 1");
    CHECK(law_error("{ factor = ['a', 1.1] }") ==
          "x.toml:1: d_mm.factor = [\"a\", 1.1]: is not a number; give a number above 0");
}

TEST_CASE("a log-normal law is a factor by another name, a choice holds values in range",
          "[document][law]") {
    const auto law = [](const std::string& text) {
        return Section::parse("d_mm = " + text, "x.toml")
            .distribution("d", Unit::length, Range::inside(0.0, 1.0));
    };
    const auto factor =
        std::get<Distribution::Factor>(law("{ log_normal = [5, 0.4054651081] }").law());
    CHECK(factor.median == Approx(0.005));
    CHECK(factor.ratio == Approx(1.5));  // exp(0.405)
    CHECK(std::get<Distribution::Choice>(law("{ choice = [3, 4] }").law()).values ==
          std::vector<double>{0.003, 0.004});
    CHECK(law_error("{ log_normal = [5, -1] }") ==
          "x.toml:1: d_mm.log_normal = [5, -1]: is out of range; give a value at least 0");
    CHECK(law_error("{ log_normal = [0, 1] }").find("a median above 0 mm") != std::string::npos);
    CHECK(law_error("{ choice = [3, 4000] }").rfind("x.toml:1: d_mm.choice", 0) == 0);
    CHECK(law_error("{ choice = [] }").find("is not a list of the right length") !=
          std::string::npos);
}

TEST_CASE("a law that is unknown, doubled or empty is told those that are", "[document][law]") {
    const std::string remedy =
        "is not a value or a law; write a number, { uniform = [low, high] }, "
        "{ normal = [mean, sd] }, { factor = [median, ratio] }, "
        "{ log_normal = [median, sd of the logarithm] } or { choice = [values] }";
    CHECK(law_error("{ gauss = [1, 2] }") == "x.toml:1: d_mm.gauss = [1, 2]: " + remedy);
    CHECK(law_error("{ normla = [1, 2] }").find("; did you mean normal? write a number") !=
          std::string::npos);
    for (const char* value : {"{}", "{ normal = [1, 2], factor = [1, 2] }"})
        CHECK(law_error(value) == "x.toml:1: d_mm = {...}: " + remedy);
    CHECK(law_error("'thin'") ==
          "x.toml:1: d_mm = \"thin\": is not a number; "
          "give a number above 0 mm and below 1000 mm");
}

}  // namespace
}  // namespace specula
