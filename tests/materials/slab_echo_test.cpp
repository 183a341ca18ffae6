#include <cmath>

#include "materials/stack.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

// What the coefficients of a slab over the band mean in range: an echo for each face.

namespace specula {
namespace {

/// |X| / sum(w) in dB at a range: Hann window, analytic signal.
class RangeProfile {
  public:
    explicit RangeProfile(const nlohmann::json& inp)
        : first_hz_(inp.at("f0_hz")), band_hz_(inp.at("B_hz")), n_(inp.at("N")) {
        const double range_m = inp.at("R0_m");
        for (int i = 0; i < n_; ++i) {
            const double f_hz = first_hz_ + band_hz_ * i / n_;
            const Stack slab{
                {{.medium = {complex_of(inp.at("eps"))}, .thickness_m = inp.at("d_m")}},
                HalfSpace{},
                f_hz};
            const double turn = 2.0 * two_pi * f_hz / speed_of_light_m_s * range_m;
            const double window = 0.5 - 0.5 * std::cos(two_pi * i / (n_ - 1));
            samples_.push_back(window *
                               std::conj(stack_reflection(slab, 1.0).te * std::polar(1.0, -turn)));
            window_sum_ += window;
        }
    }

    double level_db(double range_m) const {
        const double bin = 2.0 * band_hz_ * range_m / speed_of_light_m_s;
        Complex sum = 0.0;
        for (int i = 0; i < n_; ++i)
            sum += samples_[static_cast<std::size_t>(i)] * std::polar(1.0, -two_pi * bin * i / n_);
        return 20.0 * std::log10(std::abs(sum) / window_sum_);
    }
    double bin_m() const { return 0.5 * speed_of_light_m_s / band_hz_; }

  private:
    double first_hz_, band_hz_;
    int n_;
    std::vector<Complex> samples_;
    double window_sum_ = 0.0;
};

TEST_CASE("a slab shows an echo for each of its faces, as the reference's", "[stack][reference]") {
    const auto reference = reference_case("M10_slab_echoes");
    const auto& tolerance = reference.at("tolerance");
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        INFO(inp.dump());
        const RangeProfile profile(inp);
        const auto& bins = expect.at("native_bins_0_to_31_db");
        for (std::size_t i = 0; i < bins.size(); ++i)
            if (const double db = bins[i]; db > -50.0)
                CHECK(std::abs(profile.level_db(static_cast<double>(i) * profile.bin_m()) - db) <
                      tolerance.at("native_bins_db_above_minus50").get<double>());
        for (const auto& peak : expect.at("local_peaks_range_m_and_dB")) {
            const double range_m = peak.at(0), db = peak.at(1);
            const double step_m = tolerance.at("peak_range_m");
            CHECK(std::abs(profile.level_db(range_m) - db) < tolerance.at("peak_db").get<double>());
            CHECK(profile.level_db(range_m) >= profile.level_db(range_m - 2.0 * step_m));
            CHECK(profile.level_db(range_m) >= profile.level_db(range_m + 2.0 * step_m));
        }
    }
}

}  // namespace
}  // namespace specula
