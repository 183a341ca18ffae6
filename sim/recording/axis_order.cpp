#include "sim/recording/axis_order.hpp"

#include <algorithm>
#include <array>

#include "sim/core/document.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

enum Axis { recording, frame, chirp, tx, rx, sample, iq };
constexpr std::size_t n_axes = 7;
const std::vector<std::string> axis_names{"recording", "frame",  "chirp", "tx",
                                          "rx",        "sample", "iq"};
constexpr std::size_t most_per_axis = 65535;  ///< chirps, virtual RX, samples: a fw_frame's counts

struct Walk {
    std::array<std::size_t, n_axes> length;
    std::array<std::size_t, n_axes> stride;  ///< 0 of an axis that is not named
};

[[noreturn]] void fail(const std::string& problem, const std::string& remedy) {
    throw InputError(format("axes: {}; {}", problem, remedy));
}

Axis axis_of(const std::string& name) {
    const auto found = std::ranges::find(axis_names, name);
    if (found == axis_names.end())
        fail(format("\"{}\" is none", name), "use " + quoted_list(axis_names));
    return static_cast<Axis>(found - axis_names.begin());
}

Walk walk_of(const AxisOrder& order) {
    if (order.axes.size() != order.shape.size())
        fail(format("{} names for an array of {} axes", order.axes.size(), order.shape.size()),
             "name each, the slowest first");
    Walk walk{};
    walk.length.fill(1);
    std::array<bool, n_axes> named{};
    std::size_t stride = 1;
    for (std::size_t i = order.axes.size(); i-- > 0;) {
        const Axis axis = axis_of(order.axes[i]);
        if (named[axis]) fail(format("\"{}\" is named twice", order.axes[i]), "name each once");
        named[axis] = true;
        walk.length[axis] = order.shape[i];
        walk.stride[axis] = stride;
        if (order.shape[i] != 0 && stride > (std::size_t{1} << 48) / order.shape[i])
            fail("the lengths are beyond any file", "check them");
        stride *= order.shape[i];
    }
    if (!named[sample]) fail("no \"sample\" is named", "name each, the slowest first");
    if (named[iq] && walk.length[iq] != 2)
        fail(format("iq has length {}", walk.length[iq]), "in-phase and quadrature are two");
    return walk;
}

std::size_t size_of(const Walk& walk) {
    std::size_t n = 1;
    for (const std::size_t length : walk.length) n *= length;
    return n;
}

/// Calls use(place in the file) for every in-phase code, in the order of a dataset.
template <typename Use>
void for_each_code(const Walk& w, Use use) {
    for (std::size_t r = 0; r < w.length[recording]; ++r)
        for (std::size_t f = 0; f < w.length[frame]; ++f)
            for (std::size_t c = 0; c < w.length[chirp]; ++c)
                for (std::size_t t = 0; t < w.length[tx]; ++t)
                    for (std::size_t x = 0; x < w.length[rx]; ++x) {
                        const std::size_t row = r * w.stride[recording] + f * w.stride[frame] +
                                                c * w.stride[chirp] + t * w.stride[tx] +
                                                x * w.stride[rx];
                        for (std::size_t n = 0; n < w.length[sample]; ++n)
                            use(row + n * w.stride[sample]);
                    }
}

void check_counts(const CodeCube& cube) {
    for (const auto& [name, n] : {std::pair{"chirps", cube.n_chirps}, std::pair{"RX", cube.n_rx},
                                  std::pair{"samples", cube.n_samples}})
        if (n < 1 || n > most_per_axis)
            fail(format("{} {} per frame", n, name), format("1 to {} are possible", most_per_axis));
    if (cube.n_frames == 0) fail("there is no frame", "is the file whole?");
}

}  // namespace

CodeCube arrange(std::span<const std::int16_t> codes, const AxisOrder& order) {
    const Walk walk = walk_of(order);
    if (size_of(walk) != codes.size())
        fail(format("their lengths make {} codes, but {} are there", size_of(walk), codes.size()),
             "check the lengths, and is the file whole?");
    CodeCube cube{.n_recordings = walk.length[recording],
                  .n_frames = walk.length[recording] * walk.length[frame],
                  .n_chirps = walk.length[chirp],
                  .n_rx = walk.length[tx] * walk.length[rx],
                  .n_samples = walk.length[sample]};
    check_counts(cube);
    const bool is_complex = walk.length[iq] == 2;
    cube.in_phase.reserve(codes.size() / walk.length[iq]);
    for_each_code(walk, [&](std::size_t place) { cube.in_phase.push_back(codes[place]); });
    if (is_complex)
        for_each_code(walk, [&](std::size_t place) {
            cube.quadrature.push_back(codes[place + walk.stride[iq]]);
        });
    return cube;
}

std::vector<std::int16_t> rearrange(const CodeCube& cube, AxisOrder order) {
    for (std::size_t i = 0; i < order.axes.size(); ++i) {
        const Axis axis = axis_of(order.axes[i]);
        if (order.shape[i] != 0) continue;
        order.shape[i] = axis == frame    ? cube.n_frames
                         : axis == chirp  ? cube.n_chirps
                         : axis == rx     ? cube.n_rx
                         : axis == sample ? cube.n_samples
                         : axis == iq     ? 2
                                          : 1;
    }
    const Walk walk = walk_of(order);
    std::vector<std::int16_t> codes(size_of(walk));
    SPECULA_EXPECT(codes.size() == cube.in_phase.size() + cube.quadrature.size());
    std::size_t i = 0, q = 0;
    for_each_code(walk, [&](std::size_t place) { codes[place] = cube.in_phase[i++]; });
    if (!cube.quadrature.empty())
        for_each_code(walk, [&](std::size_t place) {
            codes[place + walk.stride[iq]] = cube.quadrature[q++];
        });
    return codes;
}

AxisOrder with_open_axis(AxisOrder order, std::size_t n_codes) {
    const auto open = std::ranges::find(order.shape, std::size_t{0});
    if (open == order.shape.end()) return order;
    std::size_t rest = 1;
    for (const std::size_t n : order.shape)
        if (n != 0) rest = rest > n_codes ? rest : rest * n;
    if (rest > n_codes)
        fail_at(2 * n_codes,
                format("the data end inside the first {}",
                       order.axes[static_cast<std::size_t>(open - order.shape.begin())]),
                "is the file whole, and are the lengths right?");
    if (n_codes % rest != 0)
        fail_at(2 * (n_codes - n_codes % rest),
                format("the data end inside {} {}",
                       order.axes[static_cast<std::size_t>(open - order.shape.begin())],
                       n_codes / rest),
                "is the file whole, and are the lengths right?");
    *open = n_codes / rest;
    return order;
}

}  // namespace specula
