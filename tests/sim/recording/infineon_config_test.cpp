#include "sim/recording/infineon_config.hpp"

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

const std::string config = R"({"device_config": {"fmcw_single_shape": {
    "end_frequency_Hz": 63500000000, "num_chirps_per_frame": 8, "num_samples_per_chirp": 64,
    "rx_antennas": [1, 2, 3], "sample_rate_Hz": 2000000, "start_frequency_Hz": 58000000000,
    "mimo_mode": "off"}}})";

std::string config_refusal(const std::string& from, const std::string& to) {
    return message_of([&] { return read_infineon_config(edited(config, from, to)).n_rx; });
}

TEST_CASE("a configuration says shape and range bin", "[recording]") {
    const InfineonConfig read = read_infineon_config(config);
    CHECK(read.n_chirps == 8);
    CHECK(read.n_samples == 64);
    CHECK(read.n_rx == 3);
    CHECK(read.bin_m() == Approx(0.0272539).epsilon(1e-5));  // c / (2 * 5.5 GHz)
    const InfineonConfig back = read_infineon_config(write_infineon_config(read));
    CHECK(back.n_chirps == 8);
    CHECK(back.n_rx == 3);
    CHECK(back.bin_m() == read.bin_m());
}

TEST_CASE("what is wrong in a configuration is named", "[recording]") {
    CHECK(message_of([] { return read_infineon_config("{\"a\": ").n_rx; }).rfind("byte ", 0) == 0);
    CHECK(config_refusal("63500000000", "1e999")
              .rfind("byte 0: holds a number beyond all range", 0) == 0);
    CHECK(config_refusal("num_chirps_per_frame", "chirps") ==
          "num_chirps_per_frame: is missing; name the config.json of an FMCW recording");
    CHECK(config_refusal("\"num_chirps_per_frame\": 8", "\"num_chirps_per_frame\": 8.5")
              .rfind("num_chirps_per_frame: 8.5: is not a whole number", 0) == 0);
    CHECK(config_refusal("64,", "-64,").rfind("num_samples_per_chirp: -64: is not above 0", 0) ==
          0);
    CHECK(config_refusal("[1, 2, 3]", "[]").rfind("rx_antennas: names none", 0) == 0);
    CHECK(config_refusal("2000000,", "\"fast\",").rfind("sample_rate_Hz: is not a number", 0) == 0);
    CHECK(config_refusal("63500000000", "57000000000").rfind("end_frequency_Hz: is not above", 0) ==
          0);
    CHECK(message_of([] { return read_infineon_config("[]").n_rx; }).rfind("device_config: ", 0) ==
          0);
}

}  // namespace
}  // namespace specula
