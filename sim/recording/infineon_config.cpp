#include "sim/recording/infineon_config.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/constants.hpp"
#include "sim/recording/byte_span.hpp"

namespace specula {

namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::string& key, const std::string& problem) {
    throw InputError(format("{}: {}; name the config.json of an FMCW recording", key, problem));
}

const Json& member(const Json& object, const std::string& key) {
    if (!object.is_object() || !object.contains(key)) fail(key, "is missing");
    return object.at(key);
}

double number(const Json& object, const std::string& key, double most) {
    const Json& value = member(object, key);
    if (!value.is_number()) fail(key, "is not a number");
    const double n = value.get<double>();
    if (!(n > 0.0 && n <= most)) fail(key, format("{}: is not above 0 and up to {}", n, most));
    return n;
}

std::size_t count(const Json& object, const std::string& key) {
    const double n = number(object, key, 65535.0);
    if (n != std::floor(n)) fail(key, format("{}: is not a whole number", n));
    return static_cast<std::size_t>(n);
}

}  // namespace

double InfineonConfig::bin_m() const {
    return speed_of_light_m_s / (2.0 * (end_hz - start_hz));
}

InfineonConfig read_infineon_config(const std::string& text) {
    Json root;
    try {
        root = Json::parse(text);
    } catch (const Json::parse_error& error) {
        fail_at(error.byte, "is not JSON", "name the config.json of an FMCW recording");
    } catch (const Json::out_of_range&) {
        fail_at(0, "holds a number beyond all range", "name the config.json of an FMCW recording");
    }
    const Json& shape = member(member(root, "device_config"), "fmcw_single_shape");
    constexpr double highest_hz = 1e12;
    InfineonConfig config{.n_chirps = count(shape, "num_chirps_per_frame"),
                          .n_samples = count(shape, "num_samples_per_chirp"),
                          .start_hz = number(shape, "start_frequency_Hz", highest_hz),
                          .end_hz = number(shape, "end_frequency_Hz", highest_hz),
                          .sample_rate_hz = number(shape, "sample_rate_Hz", highest_hz)};
    const Json& antennas = member(shape, "rx_antennas");
    if (!antennas.is_array() || antennas.empty()) fail("rx_antennas", "names none");
    config.n_rx = antennas.size();
    if (config.end_hz <= config.start_hz) fail("end_frequency_Hz", "is not above the start");
    return config;
}

std::string write_infineon_config(const InfineonConfig& config) {
    Json antennas = Json::array();
    for (std::size_t rx = 1; rx <= config.n_rx; ++rx) antennas.push_back(rx);
    Json shape{
        {"num_chirps_per_frame", config.n_chirps}, {"num_samples_per_chirp", config.n_samples},
        {"start_frequency_Hz", config.start_hz},   {"end_frequency_Hz", config.end_hz},
        {"sample_rate_Hz", config.sample_rate_hz}, {"rx_antennas", antennas}};
    if (config.chirp_repetition_s > 0.0)
        shape["chirp_repetition_time_s"] = config.chirp_repetition_s;
    if (config.high_pass_hz > 0.0) shape["hp_cutoff_Hz"] = config.high_pass_hz;
    return Json{{"device_config", {{"fmcw_single_shape", shape}}}}.dump(4) + "\n";
}

}  // namespace specula
