#include "sim/recording/code_stream.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Streams of ADC words in every packing; what is read must be what is written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using specula::Packing;
    for (const Packing packing : {Packing::int16, Packing::rdif_swizzle_2, Packing::lvds_iq})
        specula::refuses_or_reads([=] {
            const std::string again =
                specula::pack_codes(specula::unpack_codes({data, size}, packing), packing);
            if (again != std::string(data, data + size)) __builtin_trap();
        });
    return 0;
}
