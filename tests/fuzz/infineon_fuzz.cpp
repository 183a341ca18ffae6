#include "sim/recording/infineon_config.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// The configuration beside an Infineon recording.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads(
        [=] { specula::read_infineon_config(std::string(data, data + size)); });
}
