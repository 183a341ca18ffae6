#include "sim/recording/adc_injection.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// A TI injection file; what is read must be what is written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads([=] {
        const specula::AdcInjection injection = specula::read_adc_injection({data, size});
        const std::string again = specula::write_adc_injection(injection);
        if (again != std::string(data, data + size)) __builtin_trap();
    });
}
