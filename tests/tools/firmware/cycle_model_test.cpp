#include "tools/firmware/cycle_model.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

bool costs(const CycleRange& range, double low, double high) {
    return range.low == low && range.high == high;
}

TEST_CASE("instructions cost what Arm's manual for the Cortex-M4 says", "[cycles]") {
    const Instruction add{"adds", "r0, #1"}, load{"ldr.w", "r3, [r0, #4]"};
    CHECK(costs(cycles_of(add, false, {}), 1, 1));
    CHECK(costs(cycles_of({"mul", "r0, r1, r2"}, false, add), 1, 1));
    CHECK(costs(cycles_of({"smlad", "r3, r8, ip, r3"}, false, add), 1, 1));
    CHECK(costs(cycles_of({"sdiv", "r0, r0, r1"}, false, add), 2, 12));
    CHECK(costs(cycles_of({"vdiv.f32", "s0, s1, s2"}, false, add), 14, 14));
    CHECK(costs(cycles_of({"vsqrt.f32", "s0, s1"}, false, add), 14, 14));
}

TEST_CASE("a load hides behind the load that follows, not behind arithmetic", "[cycles]") {
    const Instruction load{"ldr.w", "r3, [r0, #4]"}, store{"vstr", "s0, [r1]"};
    CHECK(costs(cycles_of(load, false, store), 1, 1));
    CHECK(costs(cycles_of(load, false, {"adds", "r0, #1"}), 1, 2));
    CHECK(costs(cycles_of({"ldrd", "r0, r1, [r2]"}, false, load), 3, 3));
}

TEST_CASE("a branch costs its refill where it is taken", "[cycles]") {
    CHECK(costs(cycles_of({"bne.n", "400a54"}, false, {}), 1, 1));
    CHECK(costs(cycles_of({"bne.n", "400a54"}, true, {}), 2, 4));
    CHECK(costs(cycles_of({"pop", "{r4, r6-r8, pc}"}, true, {}), 7, 9));
}

TEST_CASE("registers in braces are counted, ranges too", "[cycles]") {
    CHECK(costs(cycles_of({"push", "{r4, lr}"}, false, {}), 3, 3));
    CHECK(costs(cycles_of({"stmdb", "sp!, {r4, r5, r6, r7, r8, r9, sl, lr}"}, false, {}), 9, 9));
    CHECK(costs(cycles_of({"vpush", "{s16-s19}"}, false, {}), 5, 5));
}

TEST_CASE("a floating-point result is waited for where the next instruction reads it", "[cycles]") {
    const Instruction product{"vmul.f32", "s12, s14, s12"};
    CHECK(costs(cycles_of(product, false, {"vadd.f32", "s1, s12, s15"}), 2, 2));
    CHECK(costs(cycles_of(product, false, {"vadd.f32", "s12, s1, s15"}), 1, 1));
    CHECK(costs(cycles_of(product, false, {"vadd.f32", "s1, s1, s120"}), 1, 1));
    CHECK(costs(cycles_of(product, false, {"vstr", "s12, [r0]"}), 2, 2));
    CHECK(costs(cycles_of({"vfma.f32", "s0, s1, s2"}, false, {"adds", "r0, #1"}), 3, 3));
}

}  // namespace
}  // namespace specula
