#include "materials/models/wood.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

double loss_tangent(const Electrics& medium) {
    return -medium.permittivity.imag() / medium.permittivity.real();
}

TEST_CASE("dry wood of 450 kg/m3 has the permittivities that were measured", "[wood]") {
    const Grained dry = Wood{.dry_density_kg_m3 = 450.0, .moisture = 0.0}.grained(60e9);
    CHECK(std::abs(dry.along.permittivity - Complex(1.90, -0.075)) <
          1e-12);                                                         // 0.3 walls of 4-j0.25
    CHECK(dry.across.permittivity.real() == Approx(1.516).margin(1e-3));  // 4^0.3
}

TEST_CASE("a field along the grain sees more wood than one across", "[wood]") {
    for (const double density : {150.0, 450.0, 800.0})
        for (const double moisture : {0.0, 0.1, 0.28}) {
            const Wood wood{.dry_density_kg_m3 = density, .moisture = moisture};
            const Grained medium = wood.grained(60e9);
            CHECK(medium.along.permittivity.real() > medium.across.permittivity.real());
            CHECK(std::abs(wood.at(60e9).permittivity -
                           0.5 * (medium.along.permittivity + medium.across.permittivity)) < 1e-15);
        }
}

TEST_CASE("wood gets denser to the wave with density and moisture", "[wood]") {
    double along = 1.0, across = 1.0, loss = 0.0;
    for (const double density : {200.0, 400.0, 600.0, 800.0}) {
        const Grained medium = Wood{.dry_density_kg_m3 = density}.grained(60e9);
        CHECK(medium.along.permittivity.real() > along);
        CHECK(medium.across.permittivity.real() > across);
        along = medium.along.permittivity.real();
        across = medium.across.permittivity.real();
    }
    for (const double moisture : {0.0, 0.05, 0.1, 0.2, 0.28, 0.4, 0.8}) {
        const Grained medium = Wood{.moisture = moisture}.grained(60e9);
        CHECK(loss_tangent(medium.across) > loss);
        loss = loss_tangent(medium.across);
    }
}

TEST_CASE("indoor wood lies in the ranges of physics.md and near ITU-R P.2040", "[wood]") {
    for (const double density : {490.0, 550.0, 650.0})  // pine to oak
        for (const double moisture : {0.06, 0.10, 0.12}) {
            const Grained medium =
                Wood{.dry_density_kg_m3 = density, .moisture = moisture}.grained(60e9);
            const double ratio =
                medium.along.permittivity.real() / medium.across.permittivity.real();
            CHECK(ratio > 1.1);
            CHECK(ratio < 1.35);
            CHECK(loss_tangent(medium.across) > 0.03);
            CHECK(loss_tangent(medium.along) < 0.10);
        }
    const Complex mean = Wood{.dry_density_kg_m3 = 500.0, .moisture = 0.10}.at(60e9).permittivity;
    CHECK(std::abs(mean - Complex(1.99, -0.113)) < 0.1);  // one isotropic fit to many species
}

TEST_CASE("wood full of walls or water has no room for more", "[wood]") {
    for (const Wood& wood : {Wood{.dry_density_kg_m3 = 1400.0, .moisture = 0.28},
                             Wood{.dry_density_kg_m3 = 1400.0, .moisture = 2.0},
                             Wood{.dry_density_kg_m3 = 400.0, .moisture = 2.0}}) {
        const Grained medium = wood.grained(60e9);
        for (const Electrics& each : {medium.along, medium.across}) {
            CHECK(each.permittivity.imag() < 0.0);
            CHECK(std::isfinite(each.permittivity.real()));
        }
    }
}

TEST_CASE("density may be given in either unit, moisture as a share", "[wood]") {
    Section section = Section::parse("dry_density_g_per_cm3 = 0.49\nmoisture = 0.1\n", "x.toml");
    const Wood wood = Wood::read(section);
    CHECK(wood.dry_density_kg_m3 == Approx(490.0));
    CHECK(std::abs(wood.wall - Complex(4.0, -0.25)) < 1e-15);
    Section wet = Section::parse("dry_density_kg_per_m3 = 490\nmoisture = 10\n", "x.toml");
    CHECK(message_of([&] { return Wood::read(wet); }).find("at most 2") != std::string::npos);
}

}  // namespace
}  // namespace specula
