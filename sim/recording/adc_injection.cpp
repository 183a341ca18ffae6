#include "sim/recording/adc_injection.hpp"

#include <array>

#include "sim/core/expect.hpp"
#include "sim/recording/code_stream.hpp"

namespace specula {

namespace {

constexpr std::size_t injection_header_bytes = 16;
constexpr std::size_t most_per_count = 65535;

struct Count {
    const char* name;
    std::size_t AdcInjection::*member;
    std::size_t most;
};
constexpr std::array<Count, 4> counts{{
    {"numAdcSamples", &AdcInjection::n_samples, most_per_count},
    {"numVirtualAntennas", &AdcInjection::n_virtual, most_per_count},
    {"numChirpsPerFrame", &AdcInjection::n_chirps, most_per_count},
    {"numFrames", &AdcInjection::n_frames, 0xffffffff},
}};

}  // namespace

AdcInjection read_adc_injection(Bytes bytes) {
    AdcInjection injection;
    const std::size_t n_codes =
        bytes.size() < injection_header_bytes ? 0 : (bytes.size() - injection_header_bytes) / 2;
    std::size_t claimed = 1;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::size_t n = u32_at(bytes, 4 * i, "the header");
        if (n == 0 || n > counts[i].most)
            fail_at(4 * i, format("{} = {}: is not 1 to {}", counts[i].name, n, counts[i].most),
                    "name a file in TI's ADC injection format");
        injection.*counts[i].member = n;
        // Beyond what is there, the product must not wrap around.
        claimed = claimed > n_codes ? claimed : claimed * n;
    }
    if (claimed != n_codes || bytes.size() % 2 != 0)
        fail_at(
            injection_header_bytes,
            format("the header asks for {} x {} x {} x {} codes of 2 bytes, but {} bytes follow",
                   injection.n_frames, injection.n_chirps, injection.n_virtual, injection.n_samples,
                   bytes.size() - injection_header_bytes),
            "is the file whole?");
    injection.codes = unpack_codes(bytes.subspan(injection_header_bytes), Packing::int16);
    return injection;
}

std::string write_adc_injection(const AdcInjection& injection) {
    SPECULA_EXPECT(injection.codes.size() == injection.n_frames * injection.n_chirps *
                                                 injection.n_virtual * injection.n_samples);
    std::string out;
    for (const Count& count : counts) append_number(out, injection.*count.member, 4);
    return out + pack_codes(injection.codes, Packing::int16);
}

}  // namespace specula
