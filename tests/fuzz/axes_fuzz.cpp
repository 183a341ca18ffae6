#include "sim/recording/axis_order.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Orders of axes: the first bytes choose names and lengths, the others are codes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const char* const names[] = {"recording", "frame",  "chirp", "tx",
                                        "rx",        "sample", "iq",    "none"};
    if (size < 1) return 0;
    const std::size_t n_axes = data[0] % 8, head = 1 + 2 * n_axes;
    if (size < head) return 0;
    specula::AxisOrder order;
    for (std::size_t i = 0; i < n_axes; ++i) {
        order.axes.emplace_back(names[data[1 + 2 * i] % 8]);
        order.shape.push_back(data[2 + 2 * i]);
    }
    const std::vector<std::int16_t> codes(data + head, data + size);
    return specula::refuses_or_reads([&] {
        order = specula::with_open_axis(order, codes.size());
        const specula::CodeCube cube = specula::arrange(codes, order);
        if (cube.in_phase.size() + cube.quadrature.size() != codes.size()) __builtin_trap();
    });
}
