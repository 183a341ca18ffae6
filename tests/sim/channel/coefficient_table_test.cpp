#include "sim/channel/coefficient_table.hpp"

#include "tests/check.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

const ChebyshevGrid cosines{0.8, 1.0, 0}, band_hz{57e9, 62e9, 0};
const Event mirror{.kind = Event::Kind::reflect, .body = 0};

/// Largest distance of a table from the coefficients themselves, on a grid of its own.
double off(const CoefficientTable& table, const Reflector& reflector) {
    double worst = 0.0;
    for (double f_hz = 57e9; f_hz <= 62e9; f_hz += 0.31e9) {
        const AngularSeries series = table.at({&f_hz, 1});
        for (double cosine = 0.8; cosine <= 1.0; cosine += 0.013) {
            std::vector<double> polynomials(series.te.size());
            chebyshev_polynomials(table.cosine.unit(cosine), polynomials);
            Complex te = 0.0, tm = 0.0;
            for (std::size_t p = 0; p < polynomials.size(); ++p) {
                te += series.te[p] * polynomials[p];
                tm += series.tm[p] * polynomials[p];
            }
            const TeTm exact = coefficients_of(mirror, reflector(f_hz), cosine);
            worst = std::max({worst, std::abs(te - exact.te), std::abs(tm - exact.tm)});
        }
    }
    return worst;
}

TEST_CASE("a table holds what sheets of any thickness reflect over band and angle", "[channel]") {
    int last = 0;
    for (const double thickness_m : {1e-3, 5e-3, 20e-3}) {
        const Reflector sheet = slab({2.6, -0.02}, thickness_m);
        const auto table = coefficient_table(mirror, sheet, cosines, band_hz);
        REQUIRE(table);
        CHECK(off(*table, sheet) < 1e-7);  // some tens of terms of 1e-8 are left out
        CHECK(table->frequency_hz.n > last);
        last = table->frequency_hz.n;
    }
}

TEST_CASE("a perfect mirror takes one term, a metre of low loss no table", "[channel]") {
    const auto table = coefficient_table(mirror, perfect_conductor(), cosines, band_hz);
    REQUIRE(table);
    CHECK(table->te.size() == 1);
    CHECK(std::abs(table->te[0] + 1.0) < 1e-14);
    CHECK_FALSE(coefficient_table(mirror, slab({2.6, -1e-4}, 1.0), cosines, band_hz));
}

}  // namespace
}  // namespace specula
