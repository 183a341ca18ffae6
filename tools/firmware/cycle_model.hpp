#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/firmware/target_build.hpp"

namespace specula {

/// The IWRL6432's Cortex-M4F runs at 160 MHz (SWRS298).
inline constexpr double cycles_per_us = 160.0;

/// Processor cycles, between what the processor's manual allows at best and at worst.
struct CycleRange {
    double low = 0.0;
    double high = 0.0;

    double mean() const { return 0.5 * (low + high); }
    CycleRange operator+(const CycleRange& other) const {
        return {low + other.low, high + other.high};
    }
};

/// Costs of one instruction by its text, e.g. "ldr.w" and "r3, [r0, #4]". `taken`: it jumped;
/// `next`: the operands of the instruction after it, for results that are waited for.
/// @eq  Arm Cortex-M4 Technical Reference Manual r0p1, tables 3-1 and 7-1 with their notes: a load
///      or store overlaps with one that follows (1 cycle), else it takes 1 or 2; a taken branch
///      refills (1 + 1..3), sdiv takes 2..12, vdiv and vsqrt 14, a floating-point result used by
///      the next instruction 1 more
/// Limit: no wait states, no DMA in the way, no interrupts.
struct Instruction {
    std::string mnemonic;
    std::string operands;
};
CycleRange cycles_of(const Instruction& instruction, bool taken, const Instruction& next);

/// Estimated cycles of each stage of the runner's bench: every executed instruction, traced once by
/// the emulator and priced by cycles_of. An estimate: nothing here was measured on the chip.
std::map<std::string, CycleRange> estimate_cycles(const TargetBuild& build,
                                                  const std::filesystem::path& folder,
                                                  const std::vector<std::string>& arguments);

}  // namespace specula
