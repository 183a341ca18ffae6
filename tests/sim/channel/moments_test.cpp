#include "sim/channel/moments.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("moments are the plain sums that they stand for", "[channel]") {
    Stream stream({.seed = 1, .purpose = "moments"});
    PairScatter pair;
    pair.weight.resize(3);
    for (int i = 0; i < 40; ++i) {
        pair.path_m.push_back(0.9 + 0.05 * stream.uniform());
        pair.cos_incidence.push_back(0.7 + 0.3 * stream.uniform());
        pair.weight[0].push_back(stream.normal());
        pair.weight[1].push_back(stream.normal());
        pair.weight[2].push_back(stream.normal());
        pair.factor.emplace_back(stream.normal(), stream.normal());
    }
    pair.centre_rad_m = 1245.0;  // near the middle of the band, as where factors are made
    const MomentGrid grid{{57e9, 62e9, 6}, {0.7, 1.0, 4}, 0.92};
    const Moments found = moments_of(pair, grid);
    REQUIRE(found.incident.size() == 6);
    REQUIRE(found.te.size() == 4 * 6);
    REQUIRE(found.tm.size() == 4 * 6);

    double worst = 0.0;
    for (std::size_t q = 0; q < 6; ++q) {
        const double k = two_pi * grid.frequency_hz.node(static_cast<int>(q)) / speed_of_light_m_s;
        for (std::size_t p = 0; p < 4; ++p) {
            std::complex<double> incident = 0.0, te = 0.0, tm = 0.0;
            for (std::size_t i = 0; i < pair.path_m.size(); ++i) {
                const double angle = std::acos((pair.cos_incidence[i] - 0.85) / 0.15);
                const auto wave = pair.factor[i] *
                                  std::polar(1.0, (1245.0 - k) * (pair.path_m[i] - 0.92)) *
                                  std::cos(static_cast<double>(p) * angle);
                if (p == 0) incident += pair.weight[0][i] * wave;
                te += pair.weight[1][i] * wave;
                tm += pair.weight[2][i] * wave;
            }
            if (p == 0) worst = std::max(worst, std::abs(found.incident[q] - incident));
            worst = std::max(worst, std::abs(found.te[p * 6 + q] - te));
            worst = std::max(worst, std::abs(found.tm[p * 6 + q] - tm));
        }
    }
    CHECK(worst < 1e-12);  // rounding of 40 terms of order 1
}

}  // namespace
}  // namespace specula
