#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"
#include "tests/sim/spectrum.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

PlateScene tilted_about_y(const Json& inp) {
    PlateScene scene;
    scene.plate = {.size_x_m = inp["L_m"], .size_y_m = inp["L_m"]};
    scene.pose.height_m = inp["H_m"];
    scene.pose.sample.about_y_rad = inp["tilt_deg"].get<double>() * pi / 180.0;
    scene.pattern = PatchPattern{};
    return scene;
}

Reflector reflector_made_of(const Json& material) {
    if (material == "PEC") return perfect_conductor();
    return slab(complex_of(material["eps"]), material["d_m"]);
}

TEST_CASE("a plate answers a whole chirp as the reference says, sample by sample and bin by bin",
          "[channel][reference]") {
    const Json reference = reference_case("N11_chirp_response");
    const double allowed_db = reference["tolerance"]["db_bins_within_30dB_of_peak"];
    const double allowed_far_db = reference["tolerance"]["db_other"];
    for (const Json& point : reference["points"]) {
        const Json& inp = point["inp"];
        const Json& expect = point["expect"];
        INFO(inp["case"]);
        const int n = inp["N"];
        const FrequencyComb comb{inp["f0_hz"], inp["B_hz"].get<double>() / n, n};
        const PlateScene scene = tilted_about_y(inp);
        const Reflector reflector = reflector_made_of(inp["material"]);
        const Channel channel = channel_of(scene.scatter(comb.last_hz()), {&reflector, 1}, comb);

        double largest = 0.0, off = 0.0;
        std::vector<double> beat;  // Re conj(h): the residual phase is left out here
        for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Complex expected(expect["h_real"][at], expect["h_imag"][at]);
            largest = std::max(largest, std::abs(expected));
            off = std::max(off, std::abs(channel.of_rx(0)[i] - expected));
            beat.push_back(channel.of_rx(0)[i].real());
        }
        CHECK(off < 1e-6 * largest);  // what channel_of promises; 4e-8 seen

        for (const std::string window : {"rect", "hann"}) {
            const Json& bins = expect["bins_1_to_24_db_" + window];
            const double peak_db = *std::max_element(bins.begin(), bins.end());
            for (std::size_t k = 0; k < bins.size(); ++k) {
                const double expected_db = bins[k];
                const double found_db =
                    decibel(amplitude_at(beat, window, static_cast<double>(k) + 1.0));
                const bool near = expected_db > peak_db - 30.0;
                INFO(window << " bin " << k + 1);
                CHECK(std::abs(found_db - expected_db) < (near ? allowed_db : allowed_far_db));
                CHECK(std::abs(found_db - expected_db) <
                      (near ? 1e-4 : 0.01));  // the same integral
            }
        }
    }
}

}  // namespace
}  // namespace specula
