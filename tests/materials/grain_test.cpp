#include "materials/grain.hpp"

#include <cmath>

#include "materials/stack.hpp"
#include "materials/transmission.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

const Electrics along{Complex(2.2, -0.17)}, across{Complex(1.7, -0.07)};

Stack board(double grain_to_field_rad) {
    Layer layer{.medium = {Complex(1.95, -0.12)}, .thickness_m = 0.018};
    layer.grain = {along, across};
    return {{layer}, HalfSpace{}, 60e9, grain_to_field_rad};
}

Stack plain(const Electrics& medium) {
    return {{{.medium = medium, .thickness_m = 0.018}}, HalfSpace{}, 60e9};
}

TEST_CASE("along and across the grain a board is a slab of that permittivity", "[grain]") {
    for (const double cosine : {1.0, 0.7}) {
        CHECK(std::abs(stack_reflection(board(0.0), cosine).te -
                       stack_reflection(plain(along), cosine).te) < 1e-15);
        CHECK(std::abs(stack_reflection(board(pi / 2), cosine).tm -
                       stack_reflection(plain(across), cosine).tm) < 1e-15);
        CHECK(std::abs(stack_transmission(board(pi / 2), cosine).te -
                       stack_transmission(plain(across), cosine).te) < 1e-15);
    }
}

TEST_CASE("head-on at any angle, each part of the field reflects for itself", "[grain]") {
    // The field as a vector in the grain's axes, reflected by each axis' own coefficient, and what
    // comes back along the field that was sent.
    const Complex r_along = stack_reflection(plain(along), 1.0).te;
    const Complex r_across = stack_reflection(plain(across), 1.0).te;
    for (double angle = -pi; angle < pi; angle += 0.3) {
        const double c = std::cos(angle), s = std::sin(angle);
        const Complex expected = (r_along * c) * c + (r_across * s) * s;
        CHECK(std::abs(stack_reflection(board(angle), 1.0).te - expected) < 1e-15);
    }
}

TEST_CASE("a mean permittivity is no substitute for a grain: the two echoes part", "[grain]") {
    // 18 mm of birefringence 0.18 turn the far face's echoes against each other by 1.3 periods.
    const double share = 0.5;
    const Electrics mean{share * along.permittivity + (1.0 - share) * across.permittivity};
    const Complex grained = stack_reflection(board(pi / 4), 1.0).te;
    CHECK(std::abs(grained - stack_reflection(plain(mean), 1.0).te) > 0.01);
}

TEST_CASE("a grain turned half round is the same grain", "[grain]") {
    for (const double angle : {0.2, 1.1}) {
        const Reflection one = stack_reflection(board(angle), 0.9);
        CHECK(std::abs(one.te - stack_reflection(board(angle + pi), 0.9).te) < 1e-15);
        CHECK(std::abs(one.te - stack_reflection(board(-angle), 0.9).te) < 1e-15);
    }
}

TEST_CASE("oblique to the grain no power is made", "[grain]") {
    for (double angle = 0.0; angle < pi; angle += 0.2) {
        const StackPower power = stack_power(board(angle), 0.8);
        CHECK(power.te.absorbed > 0.0);
        CHECK(std::norm(stack_reflection(board(angle), 0.8).te) <= power.te.reflected + 1e-15);
    }
}

TEST_CASE("layers without a grain are left alone", "[grain]") {
    Stack stack = board(0.4);
    stack.layers.push_back({.medium = {Complex(5.0, -0.3)}, .thickness_m = 0.01});
    CHECK(has_grain(stack));
    const PrincipalStacks principal = principal_stacks(stack);
    CHECK_FALSE(has_grain(principal.along));
    CHECK_FALSE(has_grain(principal.across));
    CHECK(principal.across.layers[0].medium.permittivity == across.permittivity);
    CHECK(principal.across.layers[1].medium.permittivity == Complex(5.0, -0.3));
    CHECK_FALSE(has_grain(plain(along)));
}

}  // namespace
}  // namespace specula
