#include "tools/dataset/text_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/random.hpp"
#include "tests/check.hpp"
#include "tools/dataset/frame_profiles.hpp"

namespace specula {
namespace {

TEST_CASE("a histogram counts every value once, between round bounds", "[show]") {
    Stream stream({.seed = 3, .purpose = "histogram"});
    std::vector<float> values;
    for (int i = 0; i < 500; ++i)
        values.push_back(static_cast<float>(430.0 + 55.0 * stream.uniform()));
    const Histogram histogram = histogram_of(values, 12);
    CHECK(histogram.width == 5.0);
    CHECK(histogram.first == 430.0);
    CHECK(histogram.counts.size() <= 12);
    CHECK(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t{0}) == 500);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const double begin = histogram.first + 5.0 * static_cast<double>(i);
        const auto inside = std::count_if(values.begin(), values.end(), [&](float value) {
            return value >= begin && value < begin + 5.0;
        });
        CHECK(static_cast<std::size_t>(inside) == histogram.counts[i]);
    }
}

TEST_CASE("values that are all the same are one line, not a division by nothing", "[show]") {
    CHECK(text_histogram("height", "mm", {450.0f, 450.0f}) == "height: 450 mm in all 2 frames\n");
    CHECK(text_histogram("tilt", "deg", {0.0f}) == "tilt: 0 deg in all 1 frames\n");
}

TEST_CASE("negative values and ones of any size have bars", "[show]") {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        const Histogram histogram = histogram_of({-3.0f * scale, -1.0f * scale, 8.0f * scale}, 12);
        CHECK(histogram.counts.front() > 0);
        CHECK(histogram.counts.back() > 0);
        CHECK(histogram.counts.size() <= 13);
    }
}

TEST_CASE("the SNR of a profile is its echo over the noise, where the height says", "[show]") {
    std::vector<float> profile(64, 2.0f);
    profile[1] = 900.0f;   // leakage
    profile[11] = 200.0f;  // the sample
    profile[25] = 400.0f;  // a cupboard
    CHECK(profile_snr_db(profile, 11.5) == Approx(40.0));
    CHECK(profile_snr_db(profile, -1.0) == Approx(46.02).epsilon(1e-4));  // nobody says which
    CHECK(std::isnan(profile_snr_db(std::vector<float>(64, 0.0f), 11.0)));
    CHECK(std::isnan(profile_snr_db(std::vector<float>(3, 1.0f), 1.0)));
    CHECK(std::isnan(profile_snr_db(profile, 200.0)));  // beyond the profile
}

}  // namespace
}  // namespace specula
