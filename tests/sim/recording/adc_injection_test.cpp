#include "sim/recording/adc_injection.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::string file_of(const std::vector<std::uint32_t>& header, std::size_t n_codes) {
    std::string bytes;
    for (const std::uint32_t field : header) append_number(bytes, field, 4);
    for (std::size_t i = 0; i < n_codes; ++i) append_number(bytes, i, 2);
    return bytes;
}

TEST_CASE("an injection file is header and codes as TI's demo reads them", "[recording]") {
    const AdcInjection injection{.n_samples = 3,
                                 .n_virtual = 2,
                                 .n_chirps = 1,
                                 .n_frames = 2,
                                 .codes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}};
    const std::string bytes = write_adc_injection(injection);
    CHECK(bytes == file_of({3, 2, 1, 2}, 12));
    const AdcInjection back = read_adc_injection(bytes_in(bytes));
    CHECK(back.codes == injection.codes);
    CHECK(back.n_samples == 3);
    CHECK(back.n_virtual == 2);
    CHECK(back.n_chirps == 1);
    CHECK(back.n_frames == 2);
}

TEST_CASE("headers that cannot be are refused with their byte", "[recording]") {
    const auto refusal = [](const std::string& bytes) {
        return message_of([&] { return read_adc_injection(bytes_in(bytes)).n_frames; });
    };
    CHECK(refusal("abc").rfind("byte 3: the data end inside the header", 0) == 0);
    CHECK(refusal(file_of({3, 0, 1, 2}, 12)) ==
          "byte 4: numVirtualAntennas = 0: is not 1 to 65535; name a file in TI's ADC injection "
          "format");
    CHECK(refusal(file_of({3, 2, 65536, 2}, 12)).rfind("byte 8: numChirpsPerFrame = 65536", 0) ==
          0);
    for (const std::uint32_t n_frames : {1u, 3u, 0xffffffffu})
        CHECK(refusal(file_of({3, 2, 1, n_frames}, 12)).rfind("byte 16: the header asks for ", 0) ==
              0);
    CHECK(refusal(file_of({65535, 65535, 65535, 0xffffffff}, 0)).rfind("byte 16: ", 0) == 0);
    // 2^64 codes, which 64 bits count as none.
    CHECK(refusal(file_of({32768, 32768, 32768, 524288}, 0)).rfind("byte 16: ", 0) == 0);
    CHECK(refusal(file_of({3, 2, 1, 2}, 12) + "x").rfind("byte 16: ", 0) == 0);
}

}  // namespace
}  // namespace specula
