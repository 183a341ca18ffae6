#include "sim/adc/high_pass.hpp"

#include <complex>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

struct Filter {
    double corner_hz;
    double rate_hz;
};

/// The filter's answer to a single 1 and then zeros, until it has died away.
std::vector<double> impulse_response(const Filter& filter) {
    HighPass pass(filter.corner_hz, filter.rate_hz);
    std::vector<double> response{pass.step(1.0)};
    const int settled = static_cast<int>(10.0 * filter.rate_hz / filter.corner_hz);
    for (int i = 0; i < settled; ++i) response.push_back(pass.step(0.0));
    return response;
}

std::complex<double> at(const std::vector<double>& response, double share_of_rate) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i)
        sum += response[i] * std::polar(1.0, -two_pi * share_of_rate * static_cast<double>(i));
    return sum;
}

std::complex<double> analog(double times_corner) {
    const std::complex<double> pole =
        std::complex<double>(0.0, times_corner) / std::complex<double>(1.0, times_corner);
    return pole * pole;
}

TEST_CASE("the high-pass shapes the first bins as the chip's does", "[adc][reference]") {
    const Json reference = reference_case("F09_if_hpf");
    for (const Json& point : reference["points"]) {
        const Filter filter{point["inp"]["fc_hz"], point["inp"]["fs_hz"]};
        const double n = point["inp"]["N"];
        const double share = filter.corner_hz / filter.rate_hz;
        const double allowed_db = reference["tolerance"]["db"];
        const auto response = impulse_response(filter);
        for (std::size_t k = 0; k < 24; ++k) {
            const auto found = at(response, (static_cast<double>(k) + 1.0) / n);
            INFO(filter.corner_hz << " Hz, bin " << k + 1);
            CHECK(decibel(std::abs(found)) ==
                  Approx(point["expect"]["bins_1_to_24_db"][k].get<double>()).margin(allowed_db));
            CHECK(std::arg(found) * 180.0 / pi ==
                  Approx(point["expect"]["bins_1_to_24_phase_deg"][k].get<double>())
                      .margin(170.0 * share));
        }
    }
}

TEST_CASE("the high-pass stays as near its analog model as its docstring says", "[adc]") {
    for (const double share : {0.005, 0.01, 0.02, 0.035, 0.05, 0.1}) {
        const auto response = impulse_response({share, 1.0});
        double off_db = 0.0, off_deg = 0.0, off_below_db = 0.0;
        for (double of_rate = 0.002; of_rate <= 0.4; of_rate += 0.002) {
            const Deviation off = deviation(at(response, of_rate), analog(of_rate / share));
            off_db = std::max(off_db, off.db);
            if (of_rate <= 0.25) off_below_db = std::max(off_below_db, off.db);
            off_deg = std::max(off_deg, off.phase_deg);
        }
        INFO("corner at " << share << " of the rate: " << off_db << " dB, " << off_deg << " deg");
        CHECK(off_below_db < 0.32 * share * share + 1e-8);  // rounding of 60 dB below
        CHECK(off_db < 4.9 * share * share);
        CHECK(off_deg < 170.0 * share);
        CHECK(off_db > 4.5 * share * share);  // the claim is no empty one
    }
}

TEST_CASE("two poles cost 6 dB and a quarter turn at the corner", "[adc]") {
    for (const double share : {0.005, 0.01, 0.035}) {
        const auto corner = at(impulse_response({share, 1.0}), share);
        // The docstring's level there; of the phase a sample's share of the pole's time.
        CHECK(decibel(std::abs(corner)) == Approx(decibel(0.5)).margin(0.32 * share * share));
        CHECK(std::arg(corner) == Approx(0.5 * pi).margin(7.0 * share * share));
    }
}

TEST_CASE("the corners of 700 and 1400 kHz keep their level at the chip's own rate", "[adc]") {
    for (const double corner_hz : {700e3, 1400e3}) {
        const auto response = impulse_response({corner_hz, 5e6});
        for (int bin = 1; bin <= 24; ++bin) {
            const double of_rate = bin / 128.0;
            INFO(corner_hz << " Hz, bin " << bin);
            CHECK(decibel(std::abs(at(response, of_rate))) ==
                  Approx(decibel(std::abs(analog(of_rate * 5e6 / corner_hz)))).margin(0.05));
        }
    }
}

TEST_CASE("two poles of their own corners multiply", "[adc]") {
    HighPass both({.first_hz = 175e3, .second_hz = 350e3}, 5e6);
    std::vector<double> response{both.step(1.0)};
    for (int i = 0; i < 400; ++i) response.push_back(both.step(0.0));
    const auto pole = [](double times_corner) {
        return times_corner / std::hypot(1.0, times_corner);
    };
    for (const double f : {100e3, 300e3, 900e3})
        CHECK(std::abs(at(response, f / 5e6)) ==
              Approx(pole(f / 175e3) * pole(f / 350e3)).epsilon(1e-3));  // 0.0017 dB at 0.07
}

TEST_CASE("a constant dies away behind the high-pass", "[adc]") {
    HighPass pass(175e3, 5e6);
    double last = 0.0;
    for (int i = 0; i < 200; ++i) last = pass.step(1000.0);
    CHECK(std::abs(last) < 1e-12);  // exp(-200 * 0.22) of it
}

TEST_CASE("a corner of zero lets everything through, unchanged", "[adc]") {
    HighPass pass(0.0, 5e6);
    for (const double sample : {1.0, -3.5, 1e9, 0.0}) CHECK(pass.step(sample) == sample);
}

TEST_CASE("a corner above half the sample rate is refused", "[adc]") {
    CHECK_THROWS_AS(HighPass(2.5e6, 5e6), BrokenPromise);
    CHECK_NOTHROW(HighPass(2.4e6, 5e6));
}

}  // namespace
}  // namespace specula
