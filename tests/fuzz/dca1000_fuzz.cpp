#include "sim/recording/dca1000_packets.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Packets of a capture card.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads([=] { specula::dca1000_payload({data, size}); });
}
