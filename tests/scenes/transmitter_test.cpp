#include "scenes/transmitter.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("of TDM one TX sends in each chirp, all of them in turn", "[mimo]") {
    for (int chirp = 0; chirp < 9; ++chirp)
        for (int tx = 0; tx < 3; ++tx)
            CHECK(tx_weight(Multiplexing::tdm, tx, {.chirp = chirp, .n_tx = 3}) ==
                  (chirp % 3 == tx ? 1.0 : 0.0));
}

TEST_CASE("the signs of any two BPM transmitters cancel over a period", "[mimo]") {
    for (const int n_tx : {2, 3, 4}) {
        const int period = n_tx == 2 ? 2 : 4;
        for (int a = 0; a < n_tx; ++a)
            for (int b = 0; b < n_tx; ++b) {
                double product = 0.0;
                for (int chirp = 0; chirp < period; ++chirp)
                    product += tx_weight(Multiplexing::bpm, a, {.chirp = chirp, .n_tx = n_tx}) *
                               tx_weight(Multiplexing::bpm, b, {.chirp = chirp, .n_tx = n_tx});
                CHECK(product == (a == b ? period : 0.0));
            }
    }
}

TEST_CASE("two BPM transmitters send ++ and +-", "[mimo]") {
    const auto sign = [](int tx, int chirp) {
        return tx_weight(Multiplexing::bpm, tx, {.chirp = chirp, .n_tx = 2});
    };
    CHECK(sign(0, 0) == 1.0);
    CHECK(sign(1, 0) == 1.0);
    CHECK(sign(0, 1) == 1.0);
    CHECK(sign(1, 1) == -1.0);
}

}  // namespace
}  // namespace specula
