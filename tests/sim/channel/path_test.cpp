#include "sim/channel/path.hpp"

#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

TEST_CASE("thousands of paths add up to the exact sum", "[channel][reference]") {
    const Json reference = reference_case("U01_path_sum");
    const Json& inp = reference["points"][0]["inp"];
    const Json& expect = reference["points"][0]["expect"];
    const int n = inp["N"];
    const FrequencyComb comb{inp["f0_hz"], inp["B_hz"].get<double>() / n, n};
    Channel channel = silent_channel(1, comb);
    for (std::size_t i = 0; i < inp["tau_s"].size(); ++i)
        add_path(channel, comb,
                 {.length_m = inp["tau_s"][i].get<double>() * speed_of_light_m_s,
                  .transfer = {inp["amp_re"][i], inp["amp_im"][i]}});

    double off = 0.0, power = 0.0;
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Complex exact(expect["h_re"][at], expect["h_im"][at]);
        off += std::norm(channel.of_rx(0)[i] - exact);
        power += std::norm(exact);
    }
    const double relative = std::sqrt(off / power);
    CHECK(relative < reference["tolerance"]["rel_l2"].get<double>());
    CHECK(relative < 1e-11);  // nothing is approximated: rounding of 300 turns; 2e-13 seen
}

TEST_CASE("a path reaches its own receiver only", "[channel]") {
    const FrequencyComb comb{60e9, 1e6, 4};
    Channel channel = silent_channel(3, comb);
    add_path(channel, comb, {.rx = 1, .length_m = 0.5, .transfer = {0.0, 2.0}});
    for (int i = 0; i < comb.n; ++i) {
        CHECK(channel.of_rx(0)[i] == Complex(0.0));
        CHECK(std::abs(channel.of_rx(1)[i]) == Approx(2.0).epsilon(1e-15));
        CHECK(channel.of_rx(2)[i] == Complex(0.0));
    }
}

TEST_CASE("a path of half a wavelength more arrives upside down", "[channel]") {
    const FrequencyComb comb{60e9, 0.0, 1};
    const double half_m = 0.5 * speed_of_light_m_s / comb.first_hz;
    Channel channel = silent_channel(1, comb);
    add_path(channel, comb, {.length_m = 0.7, .transfer = 1.0});
    add_path(channel, comb, {.length_m = 0.7 + half_m, .transfer = 1.0});
    CHECK(std::abs(channel.of_rx(0)[0]) < 1e-12);  // rounding of 140 turns
}

}  // namespace
}  // namespace specula
