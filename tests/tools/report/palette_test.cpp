#include "tools/report/palette.hpp"

#include "tests/check.hpp"
#include "tools/report/figure_style.hpp"

using namespace specula;

TEST_CASE("the heat map darkens steadily from almost white", "[report]") {
    const Rgb white{255, 255, 255};
    CHECK(contrast_ratio(sequential_colour(0.0), white) < 1.1);
    for (int percent = 1; percent <= 100; ++percent) {
        CAPTURE(percent);
        CHECK(contrast_ratio(sequential_colour(0.01 * percent), white) >
              contrast_ratio(sequential_colour(0.01 * (percent - 1)), white));
    }
}

TEST_CASE("numbers on the heat map can be read on every cell", "[report]") {
    for (int percent = 0; percent <= 100; ++percent) {
        const Rgb ground = sequential_colour(0.01 * percent);
        CAPTURE(percent);
        CHECK(contrast_ratio(ground, text_colour_on(ground)) >= 4.5);  // WCAG 2.1 level AA
    }
    CHECK(text_colour_on(sequential_colour(0.0)).red < 128);
    CHECK(text_colour_on(sequential_colour(1.0)).red > 128);
}

TEST_CASE("no colour of the heat map is one that the page replaces", "[report]") {
    for (int percent = 0; percent <= 100; ++percent) {
        const Rgb ground = sequential_colour(0.01 * percent);
        for (const ColourRole& role : colour_roles) {
            CHECK(ground.hex() != role.light);
            CHECK(text_colour_on(ground).hex() != role.light);
        }
    }
}
