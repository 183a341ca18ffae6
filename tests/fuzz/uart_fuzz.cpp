#include "sim/recording/uart_stream.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// A serial stream of TLVs. Every byte must be in a packet or in a gap, and a packet that is
/// written again must read the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const specula::UartStream stream = specula::read_uart({data, size});
    for (const specula::UartFrame& frame : stream.frames) {
        if (!specula::is_writable(frame)) continue;
        const std::string packet = specula::uart_packet(frame);
        const specula::UartStream again = specula::read_uart(specula::bytes_in(packet));
        if (again.frames.size() != 1 || again.frames[0].profile != frame.profile ||
            again.frames[0].probability != frame.probability ||
            (!frame.probability.empty() && again.frames[0].class_type != frame.class_type))
            __builtin_trap();
    }
    std::size_t at = 0;
    for (const specula::UartGap& gap : stream.gaps) {
        if (gap.offset < at || gap.bytes > size - gap.offset) __builtin_trap();
        at = gap.offset + gap.bytes;
    }
    return 0;
}
