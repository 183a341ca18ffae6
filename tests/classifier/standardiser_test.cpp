#include "classifier/standardiser.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"

namespace specula {
namespace {

TEST_CASE("the rows it was fitted on come out with zero mean and unit variance", "[standardiser]") {
    FeatureTable table = draw({.n_rows = 500});
    for (std::size_t i = 0; i < table.size(); ++i)
        table.features[i * 4 + 2] *= 1e-6f;  // other unit
    const Standardiser standardiser = fit_standardiser(table);
    for (std::size_t f = 0; f < 4; ++f) {
        double sum = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double x = static_cast<double>((table.row(i)[f] - standardiser.mean[f]) *
                                                 standardiser.scale[f]);
            sum += x;
            squares += x * x;
        }
        CHECK(std::abs(sum / 500.0) < 1e-6);  // float rounding
        CHECK(squares / 500.0 == Approx(1.0).epsilon(1e-5));
    }
}

TEST_CASE("a feature that is constant up to rounding is switched off", "[standardiser]") {
    FeatureTable table = draw({.n_rows = 50});
    for (std::size_t i = 0; i < table.size(); ++i) {
        table.features[i * 4 + 0] = 0.0f;
        table.features[i * 4 + 1] = 0.1f;
        table.features[i * 4 + 2] = i % 2 == 0 ? 3.0f : std::nextafter(3.0f, 4.0f);
    }
    const Standardiser standardiser = fit_standardiser(table);
    CHECK(standardiser.scale[0] == 0.0f);
    CHECK(standardiser.scale[1] == 0.0f);
    CHECK(standardiser.scale[2] == 0.0f);
    CHECK(standardiser.scale[3] > 0.0f);
}

}  // namespace
}  // namespace specula
