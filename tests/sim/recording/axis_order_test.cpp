#include "sim/recording/axis_order.hpp"

#include <algorithm>
#include <numeric>

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

/// A code that says where it belongs: frame, chirp, rx, sample in decimal digits.
std::int16_t named(std::size_t frame, std::size_t chirp, std::size_t rx, std::size_t sample) {
    return static_cast<std::int16_t>(1000 * frame + 100 * chirp + 10 * rx + sample);
}

CodeCube named_cube() {
    CodeCube cube{.n_frames = 2, .n_chirps = 3, .n_rx = 4, .n_samples = 5};
    for (std::size_t f = 0; f < 2; ++f)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t r = 0; r < 4; ++r)
                for (std::size_t n = 0; n < 5; ++n) cube.in_phase.push_back(named(f, c, r, n));
    return cube;
}

TEST_CASE("whatever the order of a file, codes find their place", "[recording]") {
    const CodeCube cube = named_cube();
    std::vector<std::string> axes{"chirp", "frame", "rx", "sample"};
    const std::vector<std::size_t> open(4, 0);
    do {
        const auto codes = rearrange(cube, {axes, open});
        std::vector<std::size_t> shape;
        for (const std::string& axis : axes)
            shape.push_back(axis == "frame" ? 2u : axis == "chirp" ? 3u : axis == "rx" ? 4u : 5u);
        const CodeCube back = arrange(codes, {axes, shape});
        CHECK(back.in_phase == cube.in_phase);
        CHECK(back.n_frames == 2);
        CHECK(back.n_rx == 4);
    } while (std::ranges::next_permutation(axes).found);
}

TEST_CASE("an interleaved file is taken apart as one does by hand", "[recording]") {
    // (sample, rx) of one chirp: rx is the faster one.
    const CodeCube cube =
        arrange(std::vector<std::int16_t>{1, 11, 2, 12, 3, 13}, {{"sample", "rx"}, {3, 2}});
    CHECK(cube.in_phase == std::vector<std::int16_t>{1, 2, 3, 11, 12, 13});
    CHECK(cube.n_frames == 1);
    CHECK(cube.n_chirps == 1);
    CHECK(cube.n_rx == 2);
    CHECK(cube.n_samples == 3);
}

TEST_CASE("recordings make frames, and transmitters virtual receivers", "[recording]") {
    std::vector<std::int16_t> codes(2 * 3 * 2 * 2 * 4);
    std::iota(codes.begin(), codes.end(), std::int16_t{0});
    const CodeCube cube =
        arrange(codes, {{"recording", "frame", "tx", "rx", "sample"}, {2, 3, 2, 2, 4}});
    CHECK(cube.n_recordings == 2);
    CHECK(cube.n_frames == 6);
    CHECK(cube.n_rx == 4);
    CHECK(cube.in_phase == codes);
}

TEST_CASE("in-phase and quadrature part wherever their axis is", "[recording]") {
    const std::vector<std::int16_t> pairs{1, -1, 2, -2, 3, -3}, halves{1, 2, 3, -1, -2, -3};
    for (const CodeCube& cube : {arrange(pairs, {{"sample", "iq"}, {3, 2}}),
                                 arrange(halves, {{"iq", "sample"}, {2, 3}})}) {
        CHECK(cube.in_phase == std::vector<std::int16_t>{1, 2, 3});
        CHECK(cube.quadrature == std::vector<std::int16_t>{-1, -2, -3});
    }
    CodeCube cube = arrange(pairs, {{"sample", "iq"}, {3, 2}});
    CHECK(rearrange(cube, {{"iq", "sample"}, {0, 0}}) == halves);
}

TEST_CASE("an open length follows from the number of codes, and a torn frame is told",
          "[recording]") {
    const AxisOrder order{{"frame", "rx", "sample"}, {0, 3, 4}};
    CHECK(with_open_axis(order, 36).shape == std::vector<std::size_t>{3, 3, 4});
    CHECK(message_of([&] { return with_open_axis(order, 40); }) ==
          "byte 72: the data end inside frame 3; is the file whole, and are the lengths right?");
    CHECK(message_of([&] { return with_open_axis(order, 11); }) ==
          "byte 22: the data end inside the first frame; is the file whole, and are the lengths "
          "right?");
}

TEST_CASE("orders that make no sense are refused", "[recording]") {
    const std::vector<std::int16_t> codes(12);
    const auto refusal = [&](const std::vector<std::string>& axes,
                             const std::vector<std::size_t>& shape) {
        return message_of([&] { return arrange(codes, {axes, shape}); });
    };
    CHECK(refusal({"frame", "antenna"}, {3, 4}).rfind("axes: \"antenna\" is none; use ", 0) == 0);
    CHECK(refusal({"frame", "frame"}, {3, 4}) == "axes: \"frame\" is named twice; name each once");
    CHECK(refusal({"frame", "rx"}, {3, 4}).rfind("axes: no \"sample\" is named", 0) == 0);
    CHECK(refusal({"frame", "sample"}, {3, 5})
              .rfind("axes: their lengths make 15 codes, but 12", 0) == 0);
    CHECK(refusal({"sample", "iq"}, {4, 3}).rfind("axes: iq has length 3", 0) == 0);
    CHECK(refusal({"sample"}, {3, 4}).rfind("axes: 1 names for an array of 2 axes", 0) == 0);
    CHECK(refusal({"frame", "rx", "sample"}, {std::size_t{1} << 40, std::size_t{1} << 40, 12})
              .rfind("axes: the lengths are beyond any file", 0) == 0);
}

}  // namespace
}  // namespace specula
