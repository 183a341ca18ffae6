#include "tools/likeness/likeness_rows.hpp"

#include <algorithm>

#include "tests/check.hpp"

namespace specula {
namespace {

/// A receiver of 128 samples that hears little: every number of it is 100 LSB, or 1 of noise.
Portrait quiet() {
    Portrait p;
    p.mean_chirp.assign(128, 100.0);
    p.mean_spectrum.assign(64, 100.0);
    p.leakage.assign(64, 100.0);
    p.room_chirp.assign(64, 100.0);
    p.noise.assign(64, 1.0);
    for (int code = -500; code < 500; ++code) p.codes.push_back(code);
    return p;
}

Radar plain_board() {
    Radar radar;
    radar.rx.resize(1);
    radar.chirp.n_samples = 128;
    radar.chirp.pass_band = 0.45;
    return radar;
}

LikenessRow row_called(const std::string& quantity, const Portrait& recorded,
                       const Portrait& simulated) {
    const auto rows = likeness_rows({recorded}, {simulated}, plain_board());
    const auto found = std::ranges::find(rows, quantity, &LikenessRow::quantity);
    REQUIRE(found != rows.end());
    return *found;
}

TEST_CASE("a receiver is like itself in every row", "[likeness]") {
    for (const LikenessRow& row : likeness_rows({quiet()}, {quiet()}, plain_board())) {
        INFO(row.quantity);
        CHECK(row.is_alike());
        CHECK(row.reason.empty());
    }
}

TEST_CASE("a difference without its cause in the chirps stays unexplained", "[likeness]") {
    Portrait loud = quiet();
    for (double& bin : loud.mean_spectrum) bin *= 3.0;
    loud.room_chirp = loud.mean_spectrum;
    const std::string band = "spectrum, bins 15 to 30, mean of dB";
    // The chirp that the room was taken from was as loud: the room is taken badly.
    CHECK_FALSE(row_called(band, loud, quiet()).is_alike());
    CHECK(row_called(band, loud, quiet()).reason.empty());
    loud.room_chirp = quiet().room_chirp;  // it was not: the room has changed
    CHECK(row_called(band, loud, quiet()).reason.find("moves") != std::string::npos);
}

TEST_CASE("weak leakage bins are excused by strong ones only", "[likeness]") {
    Portrait recorded = quiet(), simulated = quiet();
    simulated.leakage[3] = 70.0;
    CHECK_FALSE(row_called("leakage, bin 3", recorded, simulated).is_alike());
    CHECK(row_called("leakage, bin 3", recorded, simulated).reason.empty());
    recorded.leakage[1] = 1000.0;
    CHECK_FALSE(row_called("leakage, bin 3", recorded, simulated).reason.empty());
}

TEST_CASE("a board that declares no start-up has no excuse for it", "[likeness]") {
    Portrait simulated = quiet();
    simulated.mean_chirp[0] = 10.0;
    const LikenessRow row = row_called("start-up, sample 0", quiet(), simulated);
    CHECK_FALSE(row.is_alike());
    CHECK(row.reason.empty());
}

TEST_CASE("bands end where the chirp does", "[likeness]") {
    Portrait small = quiet();
    small.mean_spectrum.resize(32);
    small.leakage.resize(32);
    small.room_chirp.resize(32);
    Radar radar = plain_board();
    radar.chirp.n_samples = 64;
    const auto rows = likeness_rows({small}, {small}, radar);
    CHECK(std::ranges::count_if(rows, [](const LikenessRow& row) {
              return row.quantity.starts_with("spectrum");
          }) == 2);  // bins 7 to 14 and 15 to 27; the pass band ends at 0.45 * 64
}

}  // namespace
}  // namespace specula
